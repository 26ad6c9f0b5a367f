#include "cli/simulated_slice.h"

#include <fmt/format.h>

#include "compare/grids.h"
#include "core/error.h"
#include "core/version.h"
#include "simulator/slice.h"

namespace lacquer {

namespace {

const char* method_name(simulator::SliceMethod method) {
    return method == simulator::SliceMethod::next_event ? "next event" : "histogram";
}

// Sum of the standard errors over the sum of the values.
double relative_error(const simulator::SliceEstimate& slice) {
    double values = 0.0;
    double errors = 0.0;
    for (const simulator::RgbEstimate& pixel : slice.pixels)
        for (std::size_t channel = 0; channel < 3; ++channel) {
            values += pixel.mean[channel];
            errors += pixel.standard_error[channel];
        }
    return values > 0.0 ? errors / values : 0.0;
}

simulator::SliceEstimate simulated(const simulator::StackWalk& stack, const glm::dvec3& wo,
                                   int size, std::uint64_t samples, std::int64_t seed) {
    SimulationRun run{samples};
    return estimate_slice(stack, wo, size, run.next(samples, seed));
}

}  // namespace

SimulatedSlice simulate_slice(const Material& material, const glm::dvec3& wo, int size,
                              std::uint64_t samples, const SimulateOptions& options) {
    if (size > kMaxSimulatedSize)
        throw UsageError{fmt::format("--size: {} is over {}, the most for --method {}", size,
                                     kMaxSimulatedSize, kSimulateMethod)};
    const simulator::StackWalk stack{material, stack_options(options)};
    const simulator::SliceEstimate slice = simulated(stack, wo, size, samples, options.seed);
    const QueryGrid grid = slice_grid("slice", wo, size);
    std::vector<glm::dvec4> rows;
    for (const std::uint32_t pixel : grid.pixels) {
        const Rgb& f = slice.pixels[pixel].mean;
        rows.emplace_back(f[0], f[1], f[2], 0.0);
    }
    return {paint(grid, rows),
            {{"material", material.name},
             {"method", kSimulateMethod},
             {"estimator", method_name(slice.method)},
             {"samples", fmt::format("{}", slice.samples)},
             {"seed", fmt::format("{}", options.seed)},
             {"orders", options.orders},
             {"relative_standard_error", fmt::format("{:.3g}", relative_error(slice))},
             {"version", kVersion}}};
}

}  // namespace lacquer
