// The walk as a compute kernel in float against the simulator's in double. They share no code.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "backends/backend.h"
#include "simulator/interface.h"
#include "support/chi_square.h"
#include "support/normal.h"

namespace lacquer {
namespace {

// Mesa's software renderers end a shader's loops after 65535 iterations in all.
constexpr std::uint32_t kWalksPerQuery = 512;
constexpr std::uint32_t kQueries = 512;
constexpr double kWalks = double{kWalksPerQuery} * kQueries;
constexpr double kSuiteSignificance = 0.01;

// (alpha, eta, tau, cos_theta): both sides of 1, smooth to rough, grazing and normal, clear and
// dark.
constexpr std::array kInterfaces{
    glm::vec4{0.3f, 1.5f, 0.7f, 0.6f},   glm::vec4{1.0f, 3.0f, 1.0f, 0.2f},
    glm::vec4{0.05f, 0.7f, 0.9f, 0.5f},  glm::vec4{0.6f, 1.0f / 3, 0.5f, 1.0f},
    glm::vec4{0.0f, 1.33f, 0.8f, 0.05f}, glm::vec4{0.9f, 0.9f, 0.2f, 0.01f},
};
constexpr int kComparisons = 2 * static_cast<int>(kInterfaces.size()) * 5;

struct Sums {
    glm::dvec4 energies{0.0}, squares{0.0}, spread{0.0};
};

Sums run_kernel(Backend& backend, const glm::vec4& boundary) {
    const Material ignored;
    std::vector<glm::vec4> inputs;
    for (std::uint32_t query = 0; query < kQueries; ++query) {
        inputs.push_back(boundary);
        inputs.emplace_back(static_cast<float>(query), 0.0f, 0.0f, 0.0f);
    }
    Job job;
    job.kernel = Kernel::walk;
    job.materials = {&ignored, 1};
    job.queries_per_material = kQueries;
    job.inputs = inputs;
    job.parameters.point_count = kWalksPerQuery;
    const JobResult result = backend.run(job);
    Sums sums;
    for (std::size_t query = 0; query < kQueries; ++query) {
        sums.energies += result.rows[3 * query];
        sums.squares += result.rows[3 * query + 1];
        sums.spread += result.rows[3 * query + 2];
    }
    return sums;
}

simulator::Estimate energy(const Sums& sums, int component) {
    const simulator::Moments moments{sums.energies[component], sums.squares[component]};
    return {moments.mean(kWalks), moments.standard_error(kWalks)};
}

// Half the mean squared radius of the light that leaves above, a ratio of two sums.
simulator::Estimate variance(const Sums& sums) {
    const double ratio = sums.spread.x / sums.energies.w;
    const double residual =
        sums.spread.y - 2.0 * ratio * sums.spread.z + ratio * ratio * sums.squares.w;
    return {ratio / 2.0, std::sqrt(std::max(residual, 0.0)) / sums.energies.w / 2.0};
}

void expect_same(const simulator::Estimate& kernel, const simulator::Estimate& simulated,
                 const std::string& what) {
    // Sums of floats and their roundings, far below the noise.
    constexpr double kFloatError = 1e-5;
    const double limit =
        test::two_sided_z(test::sidak_significance(kSuiteSignificance, kComparisons));
    const double error = std::hypot(kernel.standard_error, simulated.standard_error);
    EXPECT_NEAR(kernel.mean, simulated.mean, limit * error + kFloatError) << what;
}

class WalkKernel : public ::testing::TestWithParam<std::string> {};

TEST_P(WalkKernel, AgreesWithTheSimulator) {
    const BackendEntry& entry = backend_from_name(GetParam());
    const Availability availability = entry.probe({});
    if (!availability.usable) GTEST_SKIP() << availability.detail << "; " << availability.remedy;
    const auto backend = entry.create({});
    std::uint64_t seed = 1;
    for (const glm::vec4& boundary : kInterfaces) {
        const Sums sums = run_kernel(*backend, boundary);
        const auto simulated = simulator::estimate_interface(
            {Ndf::ggx, boundary.x, boundary.x}, boundary.y, boundary.z, boundary.w,
            {static_cast<std::uint64_t>(kWalks), seed++, {}});
        const std::string what = fmt::format("alpha {} eta {} ", boundary.x, boundary.y);
        expect_same(energy(sums, 0), simulated.t_down, what + "T01");
        expect_same(energy(sums, 1), simulated.fgd, what + "FGD");
        expect_same(energy(sums, 2), simulated.r_up, what + "R10");
        expect_same(energy(sums, 3), simulated.t_up, what + "T10");
        expect_same(variance(sums), simulated.variance, what + "variance");
    }
}

INSTANTIATE_TEST_SUITE_P(Every, WalkKernel, ::testing::Values("cpp", "vulkan"),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace lacquer
