#include "backends/expect_light.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace lacquer::test {

namespace {

std::string text(const glm::vec4& v) {
    return fmt::format(" ({:g}, {:g}, {:g})", v.x, v.y, v.z);
}

}  // namespace

std::string describe(const OwnedJob& owned, std::size_t query) {
    const std::uint32_t stride = kernel_shape(owned.kernel).input_rows;
    std::string inputs;
    for (std::uint32_t row = 0; row < stride; ++row)
        inputs += text(owned.inputs[query * stride + row]);
    return fmt::format("{} of{}", owned.materials[query / owned.queries_per_material].name, inputs);
}

void expect_no_nan_infinity_or_negative_light(const OwnedJob& owned, const JobResult& result) {
    const std::uint32_t stride = kernel_shape(owned.kernel).result_rows;
    int failures = 0;
    for (std::size_t row = 0; row < result.rows.size(); ++row)
        for (int c = 0; c < 4; ++c) {
            const double value = result.rows[row][c];
            const bool is_direction = owned.kernel == Kernel::sample && row % 2 == 0 && c < 3;
            if (std::isfinite(value) && (is_direction || value >= 0.0)) continue;
            ADD_FAILURE() << describe(owned, row / stride) << ": row " << row % stride
                          << " component " << c << " is " << value;
            if (++failures == 5) return;
        }
}

}  // namespace lacquer::test
