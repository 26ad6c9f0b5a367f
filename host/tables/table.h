// A table in memory: named arrays over axes, with the record of how they were made.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tables/axis.h"

namespace lacquer {

// How numbers are stored in a file.
enum class Encoding { float16, float32 };

std::string_view encoding_name(Encoding encoding);

// Numbers over a grid; the last axis varies fastest.
struct TableArray {
    std::string name;
    std::vector<Axis> axes;
    std::vector<double> values;
    Encoding encoding = Encoding::float16;

    std::size_t channels() const { return axes.back().size; }
    bool operator==(const TableArray&) const = default;
};

// The number of values that `axes` span.
std::size_t grid_size(std::span<const Axis> axes);

struct Table {
    std::string name;           // of the file, without ".bin"
    std::string quantity;       // what the numbers mean, for people
    std::uint64_t samples = 0;  // walks per node of the dense bake
    std::uint64_t seed = 0;
    std::string backend;  // whose kernels walked; empty for the C++ walks of host/bake
    std::vector<TableArray> arrays;

    // Throws Error naming the table and the array that it has not.
    const TableArray& array(std::string_view wanted) const;

    // The same, and throws Error where its axes but the last are not those named, or have fewer
    // than two nodes, or it has another number of channels.
    const TableArray& array(std::string_view wanted, std::span<const std::string_view> axes,
                            std::size_t channels) const;
    bool operator==(const Table&) const = default;
};

// The values rounded to what their encoding can hold, so that a table in memory equals the one read
// back. Throws Error for numbers that are not finite or too large.
void round_to_encoding(Table& table);

// The same of one array, which belongs to no file.
void round_to_encoding(TableArray& array);

// Bytes of all numbers as they are stored, which is what shaders keep in memory.
std::size_t payload_bytes(const Table& table);

// Linear interpolation of all channels of `array` at one position in [0, size - 1] per axis but the
// last.
std::vector<double> interpolate(const TableArray& array, std::span<const double> positions);

}  // namespace lacquer
