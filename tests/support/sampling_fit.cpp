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

// Cells of equal solid angle between two heights, and one for samples without a direction.
struct Cells {
    double lowest;  // z: 0 over the upper hemisphere, -1 over the sphere
    int rows;

    std::size_t count() const { return static_cast<std::size_t>(rows * kColumns) + 1; }
    double row_height() const { return (1.0 - lowest) / rows; }

    static constexpr int kColumns = 64;
};

constexpr Cells kHemisphere{0.0, 32};
constexpr Cells kSphere{-1.0, 64};

constexpr int kSub = 12;  // midpoints per cell side for the expectation
constexpr int kSamples = 1'000'000;

std::vector<double> count_samples(const Sampler& sampler, const Cells& cells) {
    std::mt19937 generator(20231);
    // Of float's precision, so that samplers in float get the same numbers.
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    const auto next = [&] { return std::min(uniform(generator), 0x1.fffffep-1f); };
    std::vector<double> counts(cells.count(), 0.0);
    for (int i = 0; i < kSamples; ++i) {
        const glm::dvec3 u{next(), next(), next()};
        const std::optional<glm::dvec3> wi = sampler(u);
        if (!wi) {
            counts.back() += 1.0;
            continue;
        }
        const double turn = std::atan2(wi->y, wi->x) / (2 * kPi);
        const int row =
            std::min(static_cast<int>((wi->z - cells.lowest) / cells.row_height()), cells.rows - 1);
        const int column = std::min(static_cast<int>((turn - std::floor(turn)) * Cells::kColumns),
                                    Cells::kColumns - 1);
        counts[static_cast<std::size_t>(row * Cells::kColumns + column)] += 1.0;
    }
    return counts;
}

std::vector<double> expect_samples(const std::function<double(const glm::dvec3& wi)>& density,
                                   const Cells& cells) {
    std::vector<double> expected(cells.count(), 0.0);
    const double height = cells.row_height() / kSub;
    const double turn = 2 * kPi / (Cells::kColumns * kSub);
    double total = 0.0;
    for (int i = 0; i < cells.rows * kSub; ++i)
        for (int j = 0; j < Cells::kColumns * kSub; ++j) {
            const double z = cells.lowest + (i + 0.5) * height;
            const double phi = (j + 0.5) * turn;
            const double radius = std::sqrt(1 - z * z);
            const double share =
                height * turn * density({radius * std::cos(phi), radius * std::sin(phi), z});
            expected[static_cast<std::size_t>(i / kSub * Cells::kColumns + j / kSub)] +=
                kSamples * share;
            total += share;
        }
    expected.back() = kSamples * std::max(0.0, 1.0 - total);
    return expected;
}

}  // namespace

void expect_sampling_fit(const Sampler& sampler,
                         const std::function<double(const glm::dvec3& wi)>& density,
                         double significance, const std::string& what) {
    expect_fit(count_samples(sampler, kHemisphere), expect_samples(density, kHemisphere),
               significance, what);
}

void expect_sphere_sampling_fit(const Sampler& sampler,
                                const std::function<double(const glm::dvec3& wi)>& density,
                                double significance, const std::string& what) {
    expect_fit(count_samples(sampler, kSphere), expect_samples(density, kSphere), significance,
               what);
}

}  // namespace lacquer::test
