// The shader source's walks, on the backends that run them, against the C++ walks that bake the
// tables: every table, at its edges and at random nodes.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <functional>
#include <map>
#include <random>

#include "bake/kernel_walks.h"
#include "bake/quantity.h"
#include "support/chi_square.h"

namespace lacquer::bake {

namespace {

// Where every corner of every table is tried, and where one random node of each shows that the
// language says the same.
constexpr const char* kThoroughBackends[] = {"cpp", "vulkan"};
constexpr const char* kOtherBackends[] = {"glsl", "essl", "hlsl", "wgsl-wgpu", "wgsl-dawn", "msl"};

constexpr double kSuiteSignificance = 0.01;
constexpr int kRepeats = 32;
constexpr std::size_t kHostGain = 4;  // low-discrepancy walks need fewer for the same noise
constexpr std::size_t kCorners = 4;
constexpr std::size_t kRandomNodes = 10;
constexpr std::size_t kRandomValues = 6;  // of each node

// Walks of one repeat, by how many functions a node is made of.
const std::map<std::string, std::size_t> kSamples{
    {"t_down_thin", 192},  {"t_down_dense", 192},   {"r_up_thin", 4096}, {"r_up_dense", 4096},
    {"multiple_thin", 64}, {"multiple_dense", 128}, {"conductor", 64},   {"tir_thin", 256},
    {"tir_dense", 256},    {"mirror", 4096}};

// R10_bar itself. Its ratio to that of a clear medium, which the table holds, is one of two rare
// events near eta 1, and too wild for a z test.
void simulate_r_up(const Axis& taus, const Parameters& node, const Walks& walks, std::uint64_t seed,
                   std::span<float> values) {
    const DiffuseExits exits = walks.light_leaving(node[0], node[1], seed);
    for (std::size_t n = 0; n < taus.size; ++n)
        values[n] = static_cast<float>(exits.reflected.transmitted(axis_value(taus, n), 2.0));
}

std::vector<Quantity> all_quantities() {
    std::vector<Quantity> all;
    for (const TableBake& table : all_table_bakes())
        if (table.name != "lobes")  // a quadrature: nobody walks
            all.insert(all.end(), table.quantities.begin(), table.quantities.end());
    for (Quantity& quantity : all)
        if (quantity.name.starts_with("r_up"))
            quantity.simulate = std::bind_front(simulate_r_up, quantity.axes[2]);
    return all;
}

// Every corner of the first axes, and some more.
std::vector<std::size_t> nodes_of(const Quantity& quantity, std::mt19937_64& random) {
    const std::size_t last = quantity.nodes() - 1;
    const std::size_t row_end = quantity.axes[1].size - 1;
    std::vector<std::size_t> nodes{0, row_end, last - row_end, last};
    for (std::size_t n = 0; n < kRandomNodes; ++n) nodes.push_back(random() % quantity.nodes());
    return nodes;
}

// The first and the last value of a node, and some more.
std::vector<std::size_t> values_of(const Quantity& quantity, std::mt19937_64& random) {
    const std::size_t count = quantity.values_per_node();
    std::vector<std::size_t> values{0, count - 1};
    for (std::size_t n = 0; n < kRandomValues; ++n) values.push_back(random() % count);
    return values;
}

struct Moments {
    double mean = 0.0, standard_error = 0.0;
};

// Of each value of a node, from independent repeats.
std::vector<Moments> estimate(const Quantity& quantity, std::size_t node, const Walks& walks) {
    const Parameters parameters =
        grid_parameters(std::span{quantity.axes}.first(quantity.node_axes), node);
    const std::size_t count = quantity.values_per_node();
    std::vector<std::vector<float>> repeats(kRepeats, std::vector<float>(count));
    const auto repeat = [&](int n) {
        const std::uint64_t seed = mix_bits(mix_bits(node + 1) + static_cast<std::uint64_t>(n));
        quantity.simulate(parameters, walks, seed, repeats[static_cast<std::size_t>(n)]);
    };
    if (walks.concurrent())
        tbb::parallel_for(0, kRepeats, repeat);
    else
        for (int n = 0; n < kRepeats; ++n) repeat(n);
    std::vector<Moments> moments(count);
    for (std::size_t value = 0; value < count; ++value) {
        double squares = 0.0;
        for (const auto& values : repeats) moments[value].mean += values[value] / kRepeats;
        for (const auto& values : repeats)
            squares += std::pow(values[value] - moments[value].mean, 2);
        moments[value].standard_error = std::sqrt(squares / (kRepeats - 1) / kRepeats);
    }
    return moments;
}

// What differs without any noise: numbers and sums in float.
double rounding(const Quantity& quantity, const Parameters& point) {
    constexpr double kHalfUlp = 0x1p-24;
    constexpr double kSums = 2e-5;
    // The C++ walks look Fresnel curves up between 513 cosines; those of weak conductors have
    // corners, near which this is the most that a line between two nodes is off.
    constexpr double kCurves = 5e-4;
    if (quantity.name == "conductor") return kSums + kCurves;
    if (quantity.axes[1].name != "eta") return kSums;
    // Near 1 energies are functions of cos_theta^2 / (eta - 1), of slope below 1 in its logarithm.
    const double eta = point[1];
    const double near_one = kHalfUlp / std::abs(eta - 1.0);
    const bool smooth_critical =
        point[0] == 0.0 && eta < 1.0 && quantity.axes[2].name == "s" && point[2] == 0.5;
    if (!smooth_critical) return kSums + near_one;
    // The normal component g of the refracted ray, g^2 = eta^2 - 1 + cos_theta^2, is 0; four
    // roundings on, 1 - F = 2 g (1 + 1 / eta^2) / cos_theta is not.
    const double g = std::sqrt(4.0 * kHalfUlp);
    return kSums + near_one + 2.0 * g * (1.0 + 1.0 / (eta * eta)) / critical_cosine(eta);
}

// Comparisons of the whole suite: every backend, quantity, node and value.
int comparisons() {
    int count = 0;
    for (const Quantity& quantity : all_quantities())
        count += static_cast<int>(
            (std::size(kThoroughBackends) * (kCorners + kRandomNodes) + std::size(kOtherBackends)) *
            std::min(quantity.values_per_node(), 2 + kRandomValues));
    return count;
}

// |difference| over its standard error that no comparison exceeds. Few repeats know their spread
// badly: Student's distribution, with the degrees of freedom of one side, which is Welch's worst.
double limit() {
    const double significance = test::sidak_significance(kSuiteSignificance, comparisons());
    const boost::math::students_t student{kRepeats - 1};
    return boost::math::quantile(boost::math::complement(student, significance / 2.0));
}

// Compares the kernel's walks with the C++ walks at some nodes of every table.
void expect_agreement(const BackendEntry& entry,
                      const std::function<std::vector<std::size_t>(
                          const Quantity& quantity, std::mt19937_64& random)>& nodes) {
    const double bound = limit();
    std::mt19937_64 random{1};
    for (const Quantity& quantity : all_quantities()) {
        const std::size_t samples = kSamples.at(quantity.name);
        const KernelWalks kernel{std::string{entry.name}, entry.create({}), samples};
        const HostWalks host{samples / kHostGain};
        for (const std::size_t node : nodes(quantity, random)) {
            const std::vector<Moments> theirs = estimate(quantity, node, kernel);
            const std::vector<Moments> ours = estimate(quantity, node, host);
            for (const std::size_t value : values_of(quantity, random)) {
                const Parameters point =
                    grid_parameters(quantity.axes, node * quantity.values_per_node() + value);
                const double error =
                    std::hypot(theirs[value].standard_error, ours[value].standard_error);
                EXPECT_NEAR(theirs[value].mean, ours[value].mean,
                            bound * error + rounding(quantity, point))
                    << fmt::format("{} at {}", quantity.name, fmt::join(point, ", "));
            }
        }
    }
}

class KernelWalk : public ::testing::TestWithParam<const char*> {
 protected:
    // Skips the test where the backend cannot run.
    void SetUp() override {
        const Availability availability = entry().probe(options_);
        if (!availability.usable)
            GTEST_SKIP() << availability.detail << "; " << availability.remedy;
    }

    const BackendEntry& entry() const { return backend_from_name(GetParam()); }

    BackendOptions options_;
};

class ThoroughKernelWalk : public KernelWalk {};

TEST_P(ThoroughKernelWalk, AgreesWithTheWalksThatBakeEveryTable) {
    expect_agreement(entry(), nodes_of);
}

class OtherKernelWalk : public KernelWalk {};

TEST_P(OtherKernelWalk, AgreesWithTheWalksThatBakeEveryTable) {
    expect_agreement(entry(), [](const Quantity& quantity, std::mt19937_64& random) {
        return std::vector<std::size_t>{random() % quantity.nodes()};
    });
}

class ValidatedKernelWalk : public KernelWalk {
 protected:
    ValidatedKernelWalk() { options_.validation = true; }
};

TEST_P(ValidatedKernelWalk, DrawsNoMessageFromTheValidationLayers) {
    const KernelWalks kernel{GetParam(), entry().create(options_), 256};
    for (const Quantity& quantity : all_quantities()) {
        std::vector<float> values(quantity.values_per_node());
        const auto axes = std::span{quantity.axes}.first(quantity.node_axes);
        // The backend throws for any message.
        quantity.simulate(grid_parameters(axes, quantity.nodes() - 1), kernel, 1, values);
    }
}

const auto kName = [](const auto& test) {
    std::string name{test.param};
    std::ranges::replace(name, '-', '_');
    return name;
};
INSTANTIATE_TEST_SUITE_P(Every, ThoroughKernelWalk, ::testing::ValuesIn(kThoroughBackends), kName);
INSTANTIATE_TEST_SUITE_P(Every, OtherKernelWalk, ::testing::ValuesIn(kOtherBackends), kName);
INSTANTIATE_TEST_SUITE_P(Every, ValidatedKernelWalk, ::testing::Values("vulkan"), kName);

}  // namespace

}  // namespace lacquer::bake
