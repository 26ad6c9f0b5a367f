#include "bake/checkpoint.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "bake/sequence.h"
#include "core/error.h"
#include "core/file.h"

namespace lacquer::bake {

namespace {

std::uint64_t checksum(std::uint64_t fingerprint, std::uint64_t node,
                       std::span<const float> values) {
    std::uint64_t sum = mix_bits(fingerprint ^ mix_bits(node + 1));
    for (const float value : values) {
        std::uint32_t bits = 0;
        std::memcpy(&bits, &value, sizeof bits);
        sum = mix_bits(sum ^ bits) + sum;
    }
    return sum;
}

}  // namespace

Checkpoint::Checkpoint(std::filesystem::path file, std::uint64_t fingerprint,
                       std::size_t values_per_node, bool resume)
    : file_{std::move(file)}, fingerprint_{fingerprint}, values_per_node_{values_per_node} {
    if (resume && std::filesystem::exists(file_)) read();
    // Written anew with what is valid, so that appending follows a whole record.
    std::string kept;
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        const std::span<const float> values{values_.data() + n * values_per_node_,
                                            values_per_node_};
        const std::uint64_t sum = checksum(fingerprint_, nodes_[n], values);
        kept.append(reinterpret_cast<const char*>(&nodes_[n]), sizeof nodes_[n]);
        kept.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
        kept.append(reinterpret_cast<const char*>(&sum), sizeof sum);
    }
    write_file(file_, kept);
    stream_.open(file_, std::ios::binary | std::ios::app);
}

std::size_t Checkpoint::record_bytes() const {
    return 2 * sizeof(std::uint64_t) + values_per_node_ * sizeof(float);
}

void Checkpoint::read() {
    const std::string bytes = read_file(file_);
    std::vector<float> values(values_per_node_);
    for (std::size_t at = 0; at + record_bytes() <= bytes.size(); at += record_bytes()) {
        std::uint64_t node = 0, sum = 0;
        std::memcpy(&node, bytes.data() + at, sizeof node);
        std::memcpy(values.data(), bytes.data() + at + sizeof node, values.size() * sizeof(float));
        std::memcpy(&sum, bytes.data() + at + record_bytes() - sizeof sum, sizeof sum);
        if (sum != checksum(fingerprint_, node, values)) return;
        nodes_.push_back(node);
        values_.insert(values_.end(), values.begin(), values.end());
    }
}

bool Checkpoint::restore(std::size_t node, std::span<float> values) const {
    const auto found = std::find(nodes_.begin(), nodes_.end(), node);
    if (found == nodes_.end()) return false;
    const auto index = static_cast<std::size_t>(found - nodes_.begin());
    std::copy_n(values_.begin() + static_cast<std::ptrdiff_t>(index * values_per_node_),
                values_per_node_, values.begin());
    return true;
}

void Checkpoint::record(std::size_t node, std::span<const float> values) {
    const std::lock_guard lock{mutex_};
    const auto id = static_cast<std::uint64_t>(node);
    const std::uint64_t sum = checksum(fingerprint_, id, values);
    errno = 0;
    stream_.write(reinterpret_cast<const char*>(&id), sizeof id);
    stream_.write(reinterpret_cast<const char*>(values.data()),
                  static_cast<std::streamsize>(values.size_bytes()));
    stream_.write(reinterpret_cast<const char*>(&sum), sizeof sum);
    stream_.flush();
    if (!stream_)
        throw Error{fmt::format("writing checkpoint '{}': {}", file_.string(),
                                std::generic_category().message(errno != 0 ? errno : EIO))};
}

}  // namespace lacquer::bake
