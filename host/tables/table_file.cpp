#include "tables/table_file.h"

#include <Imath/half.h>
#include <fmt/format.h>
#include <openssl/sha.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/file.h"

namespace lacquer {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kMagic{"\x89LQTAB\r\n", 8};
constexpr std::size_t kPreamble = 56;
constexpr std::size_t kDigestAt = 24;
constexpr std::size_t kAlignment = 8;
// A header that asks for more is broken; small enough that no product of sizes overflows.
constexpr std::size_t kMaxNodes = std::size_t{1} << 12;
constexpr std::size_t kMaxAxes = 5;

static_assert(std::endian::native == std::endian::little, "numbers are copied as they lie");

template <typename Number>
void append(std::string& bytes, Number number) {
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

template <typename Number>
Number number_at(std::string_view bytes, std::size_t position) {
    Number number;
    std::memcpy(&number, bytes.data() + position, sizeof number);
    return number;
}

std::string digest(std::string_view bytes) {
    std::array<unsigned char, SHA256_DIGEST_LENGTH> hash{};
    SHA256(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), hash.data());
    return {reinterpret_cast<const char*>(hash.data()), hash.size()};
}

std::size_t value_bytes(Encoding encoding) {
    return encoding == Encoding::float16 ? 2 : 4;
}

Json axis_json(const Axis& axis) {
    Json json{{"name", axis.name}, {"mapping", mapping_name(axis.mapping)}, {"size", axis.size}};
    if (axis.mapping != Mapping::index) {
        json["from"] = axis.from;
        json["to"] = axis.to;
        json["unit"] = axis.unit;
    }
    return json;
}

std::string header_text(const Table& table) {
    Json arrays = Json::array();
    for (const TableArray& array : table.arrays) {
        Json axes = Json::array();
        for (const Axis& axis : array.axes) axes.push_back(axis_json(axis));
        arrays.push_back(
            {{"name", array.name}, {"encoding", encoding_name(array.encoding)}, {"axes", axes}});
    }
    Json header{{"name", table.name},
                {"quantity", table.quantity},
                {"samples", table.samples},
                {"seed", table.seed}};
    if (!table.backend.empty()) header["backend"] = table.backend;
    header["arrays"] = arrays;
    std::string text = header.dump();
    text.resize((text.size() + kAlignment - 1) / kAlignment * kAlignment, ' ');
    return text;
}

std::string payload_of(const Table& table) {
    std::string payload;
    for (const TableArray& array : table.arrays) {
        for (const double value : array.values) {
            const auto single = static_cast<float>(value);
            if (array.encoding == Encoding::float16)
                append(payload, Imath::half{single}.bits());
            else
                append(payload, single);
        }
    }
    return payload;
}

// Reads the parts of one file; every failure names it.
class Reader {
 public:
    Reader(std::string_view bytes, std::string_view origin) : bytes_{bytes}, origin_{origin} {}

    Table read() const {
        check_preamble();
        const auto header_bytes = number_at<std::uint32_t>(bytes_, 12);
        Table table = table_without_values(bytes_.substr(kPreamble, header_bytes));
        fill_values(table, bytes_.substr(kPreamble + header_bytes));
        return table;
    }

 private:
    [[noreturn]] void fail(const std::string& what) const {
        throw Error{fmt::format("reading table '{}': {}", origin_, what)};
    }

    void check_preamble() const {
        if (bytes_.substr(0, kMagic.size()) != kMagic.substr(0, bytes_.size()) || bytes_.empty())
            fail("it does not begin as a table file does");
        if (bytes_.size() < kPreamble) fail_size(kPreamble);
        const auto version = number_at<std::uint32_t>(bytes_, 8);
        if (version != kTableVersion)
            fail(fmt::format("it has version {}, {} than version {}, which this program reads; {}",
                             version, version < kTableVersion ? "older" : "newer", kTableVersion,
                             version < kTableVersion ? "bake it again" : "update the program"));
        const auto payload_bytes = number_at<std::uint64_t>(bytes_, 16);
        const std::uint64_t expected = kPreamble + number_at<std::uint32_t>(bytes_, 12) +
                                       std::min(payload_bytes, std::uint64_t{1} << 40);
        if (bytes_.size() != expected) fail_size(expected);
        if (digest(bytes_.substr(kPreamble)) != bytes_.substr(kDigestAt, SHA256_DIGEST_LENGTH))
            fail("its checksum does not match its contents: the file is damaged");
    }

    [[noreturn]] void fail_size(std::uint64_t expected) const {
        fail(fmt::format("it has {} bytes where {} are expected", bytes_.size(), expected));
    }

    Table table_without_values(std::string_view text) const {
        try {
            const Json header = Json::parse(text);
            Table table;
            table.name = header.at("name").get<std::string>();
            table.quantity = header.at("quantity").get<std::string>();
            table.samples = header.at("samples").get<std::uint64_t>();
            table.seed = header.at("seed").get<std::uint64_t>();
            table.backend = header.value("backend", std::string{});
            for (const Json& array : header.at("arrays")) table.arrays.push_back(array_of(array));
            return table;
        } catch (const Json::exception& error) {
            fail(fmt::format("its header is not understood: {}", error.what()));
        }
    }

    Encoding encoding_named(const std::string& name) const {
        for (const Encoding encoding : {Encoding::float16, Encoding::float32})
            if (encoding_name(encoding) == name) return encoding;
        fail(fmt::format("encoding '{}' is not known", name));
    }

    TableArray array_of(const Json& json) const {
        TableArray array;
        array.name = json.at("name").get<std::string>();
        array.encoding = encoding_named(json.at("encoding").get<std::string>());
        for (const Json& axis : json.at("axes")) array.axes.push_back(axis_of(axis, array.name));
        if (array.axes.size() > kMaxAxes)
            fail(fmt::format("array '{}' has {} axes", array.name, array.axes.size()));
        if (array.axes.empty() || array.axes.back().mapping != Mapping::index)
            fail(fmt::format("array '{}' does not end with an axis of channels", array.name));
        return array;
    }

    Axis axis_of(const Json& json, const std::string& array) const {
        Axis axis;
        axis.name = json.at("name").get<std::string>();
        axis.mapping = mapping_named(json.at("mapping").get<std::string>());
        axis.size = json.at("size").get<std::size_t>();
        if (axis.size == 0 || axis.size > kMaxNodes)
            fail(fmt::format("axis '{}' of array '{}' has {} nodes", axis.name, array, axis.size));
        if (axis.mapping == Mapping::index) return axis;
        axis.from = json.at("from").get<double>();
        axis.to = json.at("to").get<double>();
        axis.unit = json.at("unit").get<std::string>();
        const bool logarithmic = axis.mapping == Mapping::log_bent;
        if (axis.from == axis.to || (logarithmic && !(axis.from > 0.0 && axis.to > 0.0)))
            fail(fmt::format("axis '{}' of array '{}' runs from {} to {}", axis.name, array,
                             axis.from, axis.to));
        return axis;
    }

    Mapping mapping_named(const std::string& name) const {
        for (const Mapping mapping :
             {Mapping::index, Mapping::linear, Mapping::squared, Mapping::log_bent})
            if (mapping_name(mapping) == name) return mapping;
        fail(fmt::format("mapping '{}' is not known", name));
    }

    void fill_values(Table& table, std::string_view payload) const {
        std::size_t position = 0;
        for (TableArray& array : table.arrays) {
            const std::size_t width = value_bytes(array.encoding);
            const std::size_t count = grid_size(array.axes);
            if ((payload.size() - position) / width < count)
                fail(fmt::format("array '{}' needs {} values, more than there are", array.name,
                                 count));
            array.values.reserve(count);
            for (std::size_t n = 0; n < count; ++n, position += width)
                array.values.push_back(value_at(array.encoding, payload, position, array.name));
        }
        if (position != payload.size())
            fail(fmt::format("{} bytes follow the last array", payload.size() - position));
    }

    double value_at(Encoding encoding, std::string_view payload, std::size_t position,
                    const std::string& array) const {
        double value = 0.0;
        if (encoding == Encoding::float16) {
            Imath::half half;
            half.setBits(number_at<std::uint16_t>(payload, position));
            value = static_cast<float>(half);
        } else {
            value = number_at<float>(payload, position);
        }
        if (!std::isfinite(value)) fail(fmt::format("array '{}' holds {}", array, value));
        return value;
    }

    std::string_view bytes_;
    std::string_view origin_;
};

}  // namespace

std::string encode_table(const Table& table) {
    const std::string header = header_text(table);
    const std::string payload = payload_of(table);
    std::string bytes{kMagic};
    append(bytes, kTableVersion);
    append(bytes, static_cast<std::uint32_t>(header.size()));
    append(bytes, static_cast<std::uint64_t>(payload.size()));
    bytes += digest(header + payload);
    return bytes + header + payload;
}

Table decode_table(std::string_view bytes, std::string_view origin) {
    return Reader{bytes, origin}.read();
}

Table read_table(const std::filesystem::path& file) {
    return decode_table(read_file(file), file.string());
}

void write_table(const std::filesystem::path& file, const Table& table) {
    write_file(file, encode_table(table));
}

}  // namespace lacquer
