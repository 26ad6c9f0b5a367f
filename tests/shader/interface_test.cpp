// Energies of an interface as the shader source reads them from the tables' texels, against the
// reference look-up of the same bytes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/gtc/packing.hpp>
#include <random>
#include <span>

#include "shader/shader.h"
#include "tables/texels.h"

namespace lacquer::shader_test {
namespace {

const std::array<Table, kTableNames.size()>& tables() {
    static const auto all = read_tables(BAKED_TABLES);
    return all;
}

const EnergyTables& reference() {
    static const EnergyTables all{tables()};
    return all;
}

// A sum of some 40 products of coefficients up to 4 whose interpolation took some 20 roundings.
constexpr double kSum = 400.0;

// Positions on the axes are square roots, whose rounding is amplified where they begin: the tables
// change by less than 1 from node to node, and 24 nodes move by at most sqrt of a rounding.
const double kPosition = 24.0 * std::sqrt(kRounding) * 1e-2;

struct Point {
    double alpha, eta, tau, cosine;
};

std::vector<Point> points() {
    std::vector<Point> all;
    for (const double alpha : {0.0, 0.1, 1.0})
        for (const double eta : {0.34, 0.9, 1.0, 1.0001, 1.5, 2.99})
            for (const double tau : {0.0, 0.5, 1.0})
                for (const double cosine : {0.0, 0.2, 1.0})
                    all.push_back({alpha, eta, tau, cosine});
    std::mt19937 random{1};
    std::uniform_real_distribution<float> uniform{0.0f, 1.0f};
    for (int n = 0; n < 500; ++n) {
        const double eta = std::exp((2.0 * uniform(random) - 1.0) * std::log(2.99));
        all.push_back({uniform(random), eta, uniform(random), uniform(random)});
    }
    // What is compared is the formula, not the rounding of its arguments.
    for (Point& point : all)
        for (double* value : {&point.alpha, &point.eta, &point.tau, &point.cosine})
            *value = static_cast<double>(real(*value));
    return all;
}

// Holds an array over axes of the sizes that the shader source says to the texels from `first` on,
// and returns where it ends.
int expect_texels(int first, const TableArray& array, std::vector<int> sizes) {
    for (std::size_t n = 0; n < sizes.size(); ++n)
        EXPECT_EQ(static_cast<std::size_t>(sizes[n]), array.axes[n].size) << array.name;
    static const std::vector<TableTexel> texels = pack_texels(tables());
    constexpr int kHalves = 8;
    const int count = static_cast<int>(array.values.size()) / kHalves;
    for (int n = 0; n < count * kHalves; ++n) {
        const TableTexel& texel = texels.at(static_cast<std::size_t>(first + n / kHalves));
        const glm::vec2 pair = glm::unpackHalf2x16(texel[n % kHalves / 2]);
        EXPECT_EQ(pair[n % 2], array.values[static_cast<std::size_t>(n)]) << array.name << " " << n;
    }
    return first + count;
}

TEST(Interface, TexelsLieWhereTheShaderSourceReadsThem) {
    namespace s = shader;
    const auto& [thin, dense, r_up, multiple, conductor, tir, mirror, lobes] = tables();
    int next = s::LQ_LOBE_ALPHA + s::LQ_LOBE_VARIANCES;
    const auto expect_next = [&](int first, const TableArray& array, std::vector<int> sizes) {
        EXPECT_EQ(first, next) << array.name;
        next = expect_texels(first, array, std::move(sizes));
    };
    const std::vector<int> thin_sizes{s::LQ_TABLE_ALPHAS, s::LQ_T_DOWN_THIN_ETAS};
    expect_next(s::LQ_CLEAR_THIN_BELOW, clear_coefficients(thin, "below", Contrast::thin),
                thin_sizes);
    expect_next(s::LQ_CLEAR_THIN_ABOVE, clear_coefficients(thin, "above", Contrast::thin),
                thin_sizes);
    expect_next(s::LQ_CLEAR_DENSE_ABOVE, clear_coefficients(dense, "above", Contrast::dense),
                {s::LQ_TABLE_ALPHAS, s::LQ_TABLE_ETAS});
    expect_next(s::LQ_CONDUCTOR_FACETS, conductor.array("facets"),
                {s::LQ_CONDUCTOR_ALPHAS, s::LQ_CONDUCTOR_TERMS * s::LQ_COEFFICIENTS});
    expect_next(s::LQ_CONDUCTOR_MATERIALS, conductor.array("materials"),
                {s::LQ_CONDUCTOR_INDICES, s::LQ_CONDUCTOR_INDICES, s::LQ_CONDUCTOR_TERMS});
    expect_next(s::LQ_LOBE_NODES, lobes.array("nodes"),
                {s::LQ_LOBE_NODE_ALPHAS, s::LQ_LOBE_COSINES});
    EXPECT_EQ(pack_texels(tables()).size(), static_cast<std::size_t>(next));
}

TEST(Interface, TexelsInTheLibraryAreTheTables) {
    const std::vector<TableTexel> texels = pack_texels(tables());
    EXPECT_TRUE(std::ranges::equal(texels, std::span{kTableTexels, kTableTexelCount}));
}

TEST(Interface, EnergiesAreTheReferencesOfTheSameTables) {
    const double limit = roundings(kSum) + kPosition;
    for (const auto& [alpha, eta, tau, cosine] : points()) {
        const auto energies =
            shader::lq_interface_prepare(real(alpha), real(eta), vec3{real(tau), 1, real(0.5)});
        const auto t_down = shader::lq_interface_t_down(energies, real(cosine));
        const std::string where =
            fmt::format("alpha {} eta {} tau {} cos {}", alpha, eta, tau, cosine);
        EXPECT_NEAR(t_down.x, reference().t_down(cosine, alpha, eta, tau), limit) << where;
        EXPECT_NEAR(t_down.z, reference().t_down(cosine, alpha, eta, 0.5), limit) << where;
        EXPECT_NEAR(t_down.w, 1.0 - reference().fgd_dielectric(cosine, alpha, eta), limit) << where;
        EXPECT_NEAR(energies.t_up.x, reference().t_up(alpha, eta, tau), limit) << where;
        EXPECT_NEAR(energies.r_up.x, reference().r_up(alpha, eta, tau), limit) << where;
        EXPECT_NEAR(energies.r_up.y, reference().r_up(alpha, eta, 1.0), limit) << where;
        EXPECT_NEAR(shader::lq_interface_fgd_multiple(energies, real(cosine)),
                    reference().fgd_multiple(cosine, alpha, eta), limit)
            << where;
        EXPECT_NEAR(energies.multiple_average, reference().fgd_multiple_average(alpha, eta), limit)
            << where;
    }
}

TEST(Interface, VarianceIsTheReferencesWhereLightGetsThrough) {
    for (const auto& [alpha, eta, tau, cosine] : points()) {
        const double energy = reference().t_down_profile(alpha, eta, tau).average();
        if (energy < 1e-3) continue;  // a quotient of two roundings
        const auto energies = shader::lq_interface_prepare(real(alpha), real(eta), vec3{real(tau)});
        EXPECT_NEAR(
            shader::lq_spread_variance(energies.critical, shader::lq_interface_spread(energies).x),
            reference().variance(alpha, eta, tau), (roundings(kSum) + kPosition) / energy)
            << alpha << " " << eta << " " << tau;
    }
}

TEST(Interface, LobesOfLightAlongTheNormal) {
    for (int n = 0; n <= 100; ++n) {
        const double x = n / 100.0;
        EXPECT_NEAR(shader::lq_equivalent_alpha(real(0), real(2 * 0.3 * x - 0.5)),
                    reference().equivalent_alpha(0.3 * x), roundings(kSum) + kPosition);
        EXPECT_NEAR(shader::lq_normal_lobe_energy(real(x)), reference().mirror_single(1.0, x),
                    roundings(kSum) + kPosition);
    }
}

TEST(Interface, MomentsOfThePolynomialsAreTheReferences) {
    // The reference sums powers whose coefficients, up to 2^13, cancel.
    constexpr double kCancellation = 0x1p13 * 0x1p-53;
    for (int j = 0; j < 4; ++j) {
        shader::vec4 moment{0};
        moment[j] = 1;
        const shader::vec4 low = shader::lq_chebyshev_moments_low(moment);
        const shader::vec4 high = shader::lq_chebyshev_moments_high(moment);
        for (int n = 0; n < shader::LQ_COEFFICIENTS; ++n)
            EXPECT_NEAR(
                n < 4 ? low[n] : high[n - 4],
                chebyshev_moments()[static_cast<std::size_t>(n)][static_cast<std::size_t>(j)],
                roundings(8) + kCancellation);
    }
}

}  // namespace
}  // namespace lacquer::shader_test
