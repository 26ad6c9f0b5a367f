#include "tables/table.h"

#include <Imath/half.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/error.h"

namespace lacquer {

std::string_view encoding_name(Encoding encoding) {
    return encoding == Encoding::float16 ? "float16" : "float32";
}

std::size_t grid_size(std::span<const Axis> axes) {
    std::size_t size = 1;
    for (const Axis& axis : axes) size *= axis.size;
    return size;
}

const TableArray& Table::array(std::string_view wanted) const {
    const auto found = std::find_if(arrays.begin(), arrays.end(),
                                    [&](const TableArray& each) { return each.name == wanted; });
    if (found == arrays.end())
        throw Error{fmt::format("table '{}' has no array '{}'", name, wanted)};
    return *found;
}

const TableArray& Table::array(std::string_view wanted, std::span<const std::string_view> axes,
                               std::size_t channels) const {
    const TableArray& found = array(wanted);
    bool fits = found.axes.size() == axes.size() + 1 && found.channels() == channels;
    for (std::size_t n = 0; fits && n < axes.size(); ++n)
        fits = found.axes[n].name == axes[n] && found.axes[n].size >= 2;
    if (!fits)
        throw Error{fmt::format("table '{}', array '{}': expected axes {} and {} channels", name,
                                wanted, fmt::join(axes, ", "), channels)};
    return found;
}

void round_to_encoding(TableArray& array) {
    for (double& value : array.values) {
        const auto single = static_cast<float>(value);
        value = array.encoding == Encoding::float16
                    ? static_cast<double>(static_cast<float>(Imath::half{single}))
                    : static_cast<double>(single);
        if (!std::isfinite(value))
            throw Error{fmt::format("array '{}': {} does not fit {}", array.name, single,
                                    encoding_name(array.encoding))};
    }
}

void round_to_encoding(Table& table) {
    try {
        for (TableArray& array : table.arrays) round_to_encoding(array);
    } catch (const Error& error) {
        throw Error{fmt::format("table '{}', {}", table.name, error.what())};
    }
}

std::size_t payload_bytes(const Table& table) {
    std::size_t bytes = 0;
    for (const TableArray& array : table.arrays)
        bytes += array.values.size() * (array.encoding == Encoding::float16 ? 2 : 4);
    return bytes;
}

std::vector<double> interpolate(const TableArray& array, std::span<const double> positions) {
    assert(positions.size() + 1 == array.axes.size());
    const std::size_t channels = array.channels();
    std::vector<double> result(channels, 0.0);
    const std::size_t corners = std::size_t{1} << positions.size();
    for (std::size_t corner = 0; corner < corners; ++corner) {
        double weight = 1.0;
        std::size_t index = 0;
        for (std::size_t axis = 0; axis < positions.size(); ++axis) {
            const std::size_t last = array.axes[axis].size - 1;
            const auto low = std::min(static_cast<std::size_t>(positions[axis]), last);
            const double share = positions[axis] - static_cast<double>(low);
            const bool high = (corner >> axis & 1u) != 0;
            weight *= high ? share : 1.0 - share;
            index = index * array.axes[axis].size + std::min(low + (high ? 1 : 0), last);
        }
        if (weight == 0.0) continue;
        for (std::size_t channel = 0; channel < channels; ++channel)
            result[channel] += weight * array.values[index * channels + channel];
    }
    return result;
}

}  // namespace lacquer
