#include "support/sampling_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "support/expect_fit.h"

namespace lacquer::test {

namespace {

constexpr double kPi = std::numbers::pi;

// Cells of equal solid angle over the upper hemisphere, and one for samples without a direction.
constexpr int kRows = 32;
constexpr int kColumns = 64;
constexpr int kCells = kRows * kColumns + 1;
constexpr int kSub = 12;  // midpoints per cell side for the expectation
constexpr int kSamples = 1'000'000;

std::vector<double> count_samples(const Sampler& sampler) {
    std::mt19937 generator(20231);
    // Of float's precision, so that samplers in float get the same numbers.
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    const auto next = [&] { return std::min(uniform(generator), 0x1.fffffep-1f); };
    std::vector<double> counts(kCells, 0.0);
    for (int i = 0; i < kSamples; ++i) {
        const glm::dvec3 u{next(), next(), next()};
        const std::optional<glm::dvec3> wi = sampler(u);
        if (!wi) {
            counts.back() += 1.0;
            continue;
        }
        const double turn = std::atan2(wi->y, wi->x) / (2 * kPi);
        const int row = std::min(static_cast<int>(wi->z * kRows), kRows - 1);
        const int column =
            std::min(static_cast<int>((turn - std::floor(turn)) * kColumns), kColumns - 1);
        counts[static_cast<std::size_t>(row * kColumns + column)] += 1.0;
    }
    return counts;
}

std::vector<double> expect_samples(const std::function<double(const glm::dvec3& wi)>& density) {
    std::vector<double> expected(kCells, 0.0);
    const double area = 2 * kPi / (kRows * kSub) / (kColumns * kSub);
    double total = 0.0;
    for (int i = 0; i < kRows * kSub; ++i)
        for (int j = 0; j < kColumns * kSub; ++j) {
            const double z = (i + 0.5) / (kRows * kSub);
            const double phi = 2 * kPi * (j + 0.5) / (kColumns * kSub);
            const double radius = std::sqrt(1 - z * z);
            const double share =
                area * density({radius * std::cos(phi), radius * std::sin(phi), z});
            expected[static_cast<std::size_t>(i / kSub * kColumns + j / kSub)] += kSamples * share;
            total += share;
        }
    expected.back() = kSamples * std::max(0.0, 1.0 - total);
    return expected;
}

}  // namespace

void expect_sampling_fit(const Sampler& sampler,
                         const std::function<double(const glm::dvec3& wi)>& density,
                         double significance, const std::string& what) {
    expect_fit(count_samples(sampler), expect_samples(density), significance, what);
}

}  // namespace lacquer::test
