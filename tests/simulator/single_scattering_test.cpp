// Light that met one facet against the closed forms of single scattering, by chi-square over the
// outgoing hemisphere.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>

#include "simulator/estimator.h"
#include "simulator/goniophotometer.h"
#include "simulator/microsurface.h"
#include "support/chi_square.h"
#include "support/expect_fit.h"

namespace lacquer::simulator {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::uint64_t kWalks = 300'000;
constexpr double kSuiteSignificance = 0.01;
constexpr int kTests = 6 + 4 + 6;  // chi-square tests of this file

const HemisphereGrid kGrid{16, 32};

// Of index 10^9 i: reflects all but 10^-9 of the light.
const ConductorFacet kMirror{{0, 0, 0}, {1e9, 1e9, 1e9}};

// Smith's Lambda above the surface and the distribution of normals, from their textbook forms in
// spherical coordinates (Heitz 2014, Eqs. 65 to 86).
double roughness_towards(const Facets& facets, const Vec3& w) {
    const double phi = std::atan2(w.y, w.x);
    return std::hypot(facets.alpha_x * std::cos(phi), facets.alpha_y * std::sin(phi));
}

double lambda_above(const Facets& facets, const Vec3& w) {
    const double tangent = std::sqrt(1.0 - w.z * w.z) / std::abs(w.z);
    const double a = 1.0 / (roughness_towards(facets, w) * tangent);
    if (facets.ndf == Ndf::ggx) return (std::sqrt(1.0 + 1.0 / (a * a)) - 1.0) / 2.0;
    return std::exp(-a * a) / (2.0 * a * std::sqrt(kPi)) - std::erfc(a) / 2.0;
}

double density_of_normals(const Facets& facets, const Vec3& wm) {
    const double phi = std::atan2(wm.y, wm.x);
    const double tangent2 = 1.0 / (wm.z * wm.z) - 1.0;
    const double stretched = tangent2 * (std::pow(std::cos(phi) / facets.alpha_x, 2) +
                                         std::pow(std::sin(phi) / facets.alpha_y, 2));
    const double scale = kPi * facets.alpha_x * facets.alpha_y * std::pow(wm.z, 4);
    if (facets.ndf == Ndf::beckmann) return std::exp(-stretched) / scale;
    return 1.0 / (scale * std::pow(1.0 + stretched, 2));
}

double inverse_g2(const Facets& facets, const Vec3& wi, const Vec3& wo) {
    return 1.0 + lambda_above(facets, wi) + lambda_above(facets, wo);
}

// f |cos_theta_i| of perfect mirrors: D G2 / (4 cos_theta_o).
double mirror_density(const Facets& facets, const Vec3& wi, const Vec3& wo) {
    return density_of_normals(facets, glm::normalize(wi + wo)) /
           (4.0 * wo.z * inverse_g2(facets, wi, wo));
}

// d'Eon et al. 2023, Eqs. 15 to 19: f = (1 - E) f_top + E f_bottom, E = w_bottom^(1 / G2_top).
double two_strata_density(const Facets& top, const Facets& bottom, double top_weight,
                          const Vec3& wi, const Vec3& wo) {
    const double below = std::pow(1.0 - top_weight, inverse_g2(top, wi, wo));
    return (1.0 - below) * mirror_density(top, wi, wo) + below * mirror_density(bottom, wi, wo);
}

// Fresnel's equations by their amplitudes, cos_theta_i > 0; the transmitted share.
double fresnel_transmittance(double cos_i, double eta) {
    const double sin2_t = (1.0 - cos_i * cos_i) / (eta * eta);
    if (sin2_t >= 1.0) return 0.0;
    const double cos_t = std::sqrt(1.0 - sin2_t);
    const double s = 2.0 * cos_i / (cos_i + eta * cos_t);
    const double p = 2.0 * cos_i / (eta * cos_i + cos_t);
    return eta * cos_t / cos_i * (s * s + p * p) / 2.0;
}

// Refracted once, over both strata of the rule P_top + P_bot = B(1 + Lambda_i, 1 + Lambda_o)
// (d'Eon et al. 2023, Eqs. 20 and 21, for equal strata) with the Jacobian of Walter et al. 2007,
// Eq. 17. `wt` below the surface.
double refracted_density(const Facets& facets, double eta, const Vec3& wt, const Vec3& wo) {
    Vec3 wm = glm::normalize(wo + eta * wt);
    if (wm.z < 0.0) wm = -wm;
    const double cos_o = glm::dot(wo, wm);
    const double cos_t = glm::dot(wt, wm);
    if (cos_o <= 0.0 || cos_t >= 0.0) return 0.0;
    const double jacobian = eta * eta * -cos_t / std::pow(cos_o + eta * cos_t, 2);
    const double both = std::beta(1.0 + lambda_above(facets, wo), 1.0 + lambda_above(facets, -wt));
    return density_of_normals(facets, wm) * cos_o / wo.z * both *
           fresnel_transmittance(cos_o, eta) * jacobian;
}

struct CellTally {
    std::vector<double> cells = std::vector<double>(kGrid.cell_count());
    std::uint64_t count = 0;

    void merge(const CellTally& other) {
        for (std::size_t cell = 0; cell < cells.size(); ++cell) cells[cell] += other.cells[cell];
    }
};

// Counts per cell of the grid, of walks that met one facet, and last the count of all others.
std::vector<double> observed_cells(const Surface& surface, const Vec3& wo, bool below) {
    const SurfaceWalk walk{surface};
    const auto tally = run_walks<CellTally>(
        {kWalks, 1, {}},
        [&](RandomStream& random, CellTally& sum) {
            const Crossing crossing = walk.cross(-wo, random, 1);
            if (!crossing.lost && crossing.below == below)
                ++sum.cells[kGrid.cell(crossing.direction)];
        },
        1 << 15);
    std::vector<double> counts = tally.cells;
    double rest = static_cast<double>(kWalks);
    for (const double count : counts) rest -= count;
    counts.push_back(rest);
    return counts;
}

// The same from a density, by the midpoint rule within each cell.
std::vector<double> expected_cells(const std::function<double(const Vec3&)>& density, bool below) {
    constexpr int kSteps = 16;
    std::vector<double> counts;
    double rest = static_cast<double>(kWalks);
    const double cell_angle = 2.0 * kPi / (kGrid.rows * kGrid.columns);
    for (int row = 0; row < kGrid.rows; ++row)
        for (int column = 0; column < kGrid.columns; ++column) {
            double sum = 0.0;
            for (int j = 0; j < kSteps; ++j)
                for (int i = 0; i < kSteps; ++i) {
                    const double z = (row + (j + 0.5) / kSteps) / kGrid.rows;
                    const double phi = 2.0 * kPi * (column + (i + 0.5) / kSteps) / kGrid.columns;
                    const double r = std::sqrt(1.0 - z * z);
                    sum += density({r * std::cos(phi), r * std::sin(phi), below ? -z : z});
                }
            counts.push_back(static_cast<double>(kWalks) * cell_angle * sum / (kSteps * kSteps));
            rest -= counts.back();
        }
    counts.push_back(rest);
    return counts;
}

void expect_fit(const Surface& surface, const Vec3& wo, bool below,
                const std::function<double(const Vec3&)>& density, const std::string& what) {
    test::expect_fit(observed_cells(surface, wo, below), expected_cells(density, below),
                     test::sidak_significance(kSuiteSignificance, kTests), what);
}

Vec3 direction(double cos_theta, double phi) {
    const double sine = std::sqrt(1.0 - cos_theta * cos_theta);
    return {sine * std::cos(phi), sine * std::sin(phi), cos_theta};
}

TEST(SingleScattering, UniformMirrorsFollowTheSmithBrdf) {
    for (const Ndf ndf : {Ndf::ggx, Ndf::beckmann})
        for (const auto& [alpha_x, alpha_y] : {std::pair{0.5, 0.5}, {1.0, 1.0}, {0.3, 0.8}}) {
            const Facets facets{ndf, alpha_x, alpha_y};
            const Vec3 wo = direction(0.55, 0.7);
            expect_fit(
                {Blend::Operator::asymmetric, {{1.0, facets, kMirror}}}, wo, false,
                [&](const Vec3& wi) { return mirror_density(facets, wi, wo); },
                "alpha " + std::to_string(alpha_x) + " " + std::to_string(alpha_y));
        }
}

TEST(SingleScattering, TwoStrataFollowTheAsymmetricBlend) {
    const Facets smoother{Ndf::ggx, 0.364, 0.364};
    const Facets rougher{Ndf::ggx, 0.91, 0.91};
    const Facets brushed{Ndf::beckmann, 0.3, 0.9};
    for (const auto& [top, bottom, weight] : {std::tuple{rougher, smoother, 0.5},
                                              {smoother, rougher, 0.5},
                                              {brushed, smoother, 0.2},
                                              {smoother, brushed, 0.8}}) {
        const Vec3 wo = direction(std::cos(0.75), 0.4);
        expect_fit(
            {Blend::Operator::asymmetric,
             {{weight, top, kMirror}, {1.0 - weight, bottom, kMirror}}},
            wo, false,
            [&, t = top, b = bottom, w = weight](const Vec3& wi) {
                return two_strata_density(t, b, w, wi, wo);
            },
            "top " + std::to_string(top.alpha_x) + " weight " + std::to_string(weight));
    }
}

TEST(SingleScattering, RefractionFollowsTheBetaFunction) {
    for (const double eta : {0.7, 1.5})
        for (const auto& facets : {Facets{Ndf::ggx, 0.4, 0.4}, Facets{Ndf::ggx, 0.9, 0.5},
                                   Facets{Ndf::beckmann, 0.6, 0.6}}) {
            const Vec3 wo = direction(0.6, 0.3);
            expect_fit(
                {Blend::Operator::asymmetric, {{1.0, facets, DielectricFacet{eta}}}}, wo, true,
                [&](const Vec3& wt) { return refracted_density(facets, eta, wt, wo); },
                "eta " + std::to_string(eta) + " alpha " + std::to_string(facets.alpha_x));
        }
}

}  // namespace
}  // namespace lacquer::simulator
