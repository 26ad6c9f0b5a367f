// What the coated models lose where a sampler interpolates the tables, whose weights hardware
// rounds to 8 bits: the shader source in double with such weights against the reference.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace lacquer::sampler {

// As D3D11 (7.18.16.1) and Vulkan (subTexelPrecisionBits >= 4; GPUs have 8) define linear filters.
constexpr double kWeightSteps = 256.0;
constexpr double kWeightError = 0.5 / kWeightSteps;

inline double rounded_weight(double share) {
    return std::round(share * kWeightSteps) / kWeightSteps;
}

}  // namespace lacquer::sampler

// Where the shader source makes a segment of an axis, its share is such a weight.
#define LqSegment(low, high, share)               \
    LqSegment {                                   \
        low, high, sampler::rounded_weight(share) \
    }
#include "shading/shader_double.h"
//
#include "coated_surface.h"
#include "tables/profile.h"

namespace lacquer::reference {
namespace {

using namespace surfaces;
using sampler::kWeightError;

// Of albedo.
constexpr double kMostAlbedoError = 1e-3;

// Relative to |f|, at least 1e-3, as `lacquer compare` measures: 99 of 100 keep to it.
constexpr double kUsualLobeError = 2e-3;
constexpr double kLeastF = 1e-3;

constexpr int kPlaces = 33;  // directions per node
constexpr int kMaterials = 20000;

using Nodes = std::vector<double>;

Nodes nodes_of(const Axis& axis) {
    Nodes nodes;
    for (std::size_t n = 0; n < axis.size; ++n) nodes.push_back(axis_value(axis, n));
    return nodes;
}

// Values over alpha, eta and tau, several at each node, and how far the next nodes are.
class Grid {
 public:
    Grid(const std::array<Nodes, 3>& axes, const auto& values_at) : axes_{axes} {
        for (const double alpha : axes[0])
            for (const double eta : axes[1])
                for (const double tau : axes[2]) values_.push_back(values_at(alpha, eta, tau));
    }

    // The sum over the axes of the largest change from a node to the next: per rounding of weights.
    double largest_steps() const {
        const std::size_t stride[] = {axes_[1].size() * axes_[2].size(), axes_[2].size(), 1};
        double sum = 0.0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            double largest = 0.0;
            for (std::size_t n = 0; n < values_.size(); ++n)
                if (n / stride[axis] % axes_[axis].size() + 1 < axes_[axis].size())
                    largest = std::max(largest, step(values_[n], values_[n + stride[axis]]));
            sum += largest;
        }
        return sum;
    }

 private:
    static double step(const Nodes& here, const Nodes& next) {
        double largest = 0.0;
        for (std::size_t i = 0; i < here.size(); ++i)
            largest = std::max(largest, std::abs(next[i] - here[i]));
        return largest;
    }

    std::array<Nodes, 3> axes_;
    std::vector<Nodes> values_;
};

// What rounding the weights may change, at most: the interpolation is linear in each of them.
struct Errors {
    double t_down = 0.0;    // T01, at any direction; so of its averages too
    double multiple = 0.0;  // m
    double dimming = 0.0;   // of R10_bar
};

// Along eta a direction keeps its place on the profile, not its cosine.
template <typename At>
Nodes along_profile(double eta, Contrast contrast, const At& at) {
    Nodes values;
    for (int n = 0; n < kPlaces; ++n)
        values.push_back(at(profile_cosine(n / (kPlaces - 1.0), contrast, eta)));
    return values;
}

Errors errors_of(Contrast contrast) {
    const auto all = read_tables(BAKED_TABLES);
    const bool thin = contrast == Contrast::thin;
    const auto axes_of = [](const TableArray& maps, const TableArray& absorption) {
        return std::array{nodes_of(maps.axes[0]), nodes_of(maps.axes[1]),
                          nodes_of(absorption.axes[0])};
    };
    const Table& t_down = all[thin ? 0 : 1];
    const Grid transmission{axes_of(t_down.array("above"), t_down.array("absorption")),
                            [&](double alpha, double eta, double tau) {
                                const auto profile = tables().t_down_profile(alpha, eta, tau);
                                return along_profile(eta, contrast,
                                                     [&](double c) { return profile.at(c); });
                            }};
    const std::string side = thin ? "thin_" : "dense_";
    const auto axes = axes_of(all[2].array(side + "maps"), all[2].array(side + "absorption"));
    const Grid dimming{axes, [](double alpha, double eta, double tau) {
                           return Nodes{tables().r_up_dimming(alpha, eta, tau)};
                       }};
    const Grid multiple{{axes[0], axes[1], {1.0}}, [&](double alpha, double eta, double) {
                            return along_profile(eta, contrast, [&](double c) {
                                return tables().fgd_multiple(c, alpha, eta);
                            });
                        }};
    return {kWeightError * transmission.largest_steps(), kWeightError * multiple.largest_steps(),
            kWeightError * dimming.largest_steps()};
}

// A random material of one coat, and what the errors of the tables make of it.
struct Case {
    double alpha, eta;
    glm::dvec3 tau, rho;
    Errors errors;

    CoatedSurface exact(BaseLobe lobe) const {
        return prepare(coated(eta, ggx(alpha), {tau.x, tau.y, tau.z}, {rho.x, rho.y, rho.z}), lobe);
    }

    shader::LqCoatedSurface filtered(BaseLobe lobe) const {
        const int shape =
            lobe == BaseLobe::ggx ? shader::LQ_BASE_LOBE_GGX : shader::LQ_BASE_LOBE_EXACT;
        return shader::lq_coated_prepare(
            {{shader::LQ_NDF_GGX, alpha, alpha}, eta, tau, rho, shape});
    }

    // Relative error of 1 / (1 - rho R10_bar), R10_bar = dimming (1 - T10_bar).
    double series_error(int c) const {
        const double r_up = tables().r_up(alpha, eta, tau[c]);
        return rho[c] * (errors.dimming + errors.t_down / (eta * eta)) / (1.0 - rho[c] * r_up);
    }

    // Of T01(wo) rho T10_bar / (1 - rho R10_bar).
    double base_albedo_error(const CoatedSurface& surface, const glm::dvec3& wo, int c) const {
        const double entering = surface.base.entering[static_cast<std::size_t>(c)].at(wo.z);
        const double r_up = tables().r_up(alpha, eta, tau[c]);
        const double t_up_error = rho[c] * errors.t_down / (eta * eta) / (1.0 - rho[c] * r_up);
        return errors.t_down * surface.base.returned[c] +
               entering * (t_up_error + surface.base.returned[c] * series_error(c));
    }

    // Of the `exact` f: T01(wi) T01(wo) spread + m(wi) m(wo) / (pi m_average).
    double lobe_error(const CoatedSurface& surface, const glm::dvec3& wi, const glm::dvec3& wo,
                      int c) const {
        const TransmissionProfile& profile = surface.base.entering[static_cast<std::size_t>(c)];
        const double t_i = profile.at(wi.z), t_o = profile.at(wo.z);
        const double base =
            surface.base.spread[c] * ((t_i + t_o) * errors.t_down + t_i * t_o * series_error(c));
        const double m_i = tables().fgd_multiple(wi.z, alpha, eta);
        const double m_o = tables().fgd_multiple(wo.z, alpha, eta);
        const double average =
            std::max(tables().fgd_multiple_average(alpha, eta), reference::kLeastMultipleAverage);
        const double again =
            (m_i + m_o + m_i * m_o / average) * errors.multiple / (std::numbers::pi * average);
        return base + again;
    }
};

class SamplerFilter : public ::testing::Test {
 protected:
    Case next_case() {
        const auto number = [&] {
            return random_() % 4 == 0 ? static_cast<double>(random_() % 2) : uniform_(random_);
        };
        const auto colour = [&] { return glm::dvec3{number(), number(), number()}; };
        const double eta = std::exp((2.0 * uniform_(random_) - 1.0) * std::log(3.0));
        static const Errors thin = errors_of(Contrast::thin), dense = errors_of(Contrast::dense);
        return {number(), eta, colour(), colour(), eta < 1.0 ? thin : dense};
    }

    glm::dvec3 direction() {
        const double cosine = uniform_(random_);
        const double sine = std::sqrt((1.0 - cosine) * (1.0 + cosine));
        const double phi = 2.0 * std::numbers::pi * uniform_(random_);
        return {sine * std::cos(phi), sine * std::sin(phi), cosine};
    }

 private:
    std::mt19937_64 random_{1};
    std::uniform_real_distribution<double> uniform_{0.0, 1.0};
};

// First order in the errors; two of them meet in no more than this share of it.
constexpr double kSecondOrder = 1.02;

TEST_F(SamplerFilter, ChangesAlbedosByLessThanItsWeightsDoPerNode) {
    double largest = 0.0;
    for (int n = 0; n < kMaterials; ++n) {
        const Case material = next_case();
        const CoatedSurface exact = material.exact(BaseLobe::exact);
        const glm::dvec3 wo = direction();
        const Albedo expected = albedo(exact, wo);
        const auto found = shader::lq_coated_albedo(material.filtered(BaseLobe::exact), wo);
        for (int c = 0; c < 3; ++c) {
            const double direct = std::abs(found.direct[c] - expected.direct[c]);
            const double base = std::abs(found.base[c] - expected.base[c]);
            EXPECT_LE(direct, kSecondOrder * material.errors.t_down + 1e-6);
            EXPECT_LE(base, kSecondOrder * material.base_albedo_error(exact, wo, c) + 1e-6)
                << material.alpha << " " << material.eta << " " << material.tau[c];
            largest = std::max({largest, direct, base});
        }
    }
    fmt::print("largest error of an albedo: {:.5f}; weights may change T01 by {:.5f}\n", largest,
               std::max(errors_of(Contrast::thin).t_down, errors_of(Contrast::dense).t_down));
    EXPECT_LE(largest, kMostAlbedoError);
}

double relative(double error, double f) {
    return error / std::max(std::abs(f), kLeastF);
}

void expect_usual_lobe_error(std::vector<double> errors) {
    std::ranges::sort(errors);
    const double usual = errors[errors.size() * 99 / 100];
    fmt::print("relative error of f: median {:.1e}, 99 of 100 below {:.1e}, largest {:.1e}\n",
               errors[errors.size() / 2], usual, errors.back());
    EXPECT_LE(usual, kUsualLobeError);
}

TEST_F(SamplerFilter, ChangesTheExactLobeByLessThanItsWeightsDoPerNode) {
    std::vector<double> errors;
    for (int n = 0; n < kMaterials; ++n) {
        const Case material = next_case();
        const CoatedSurface exact = material.exact(BaseLobe::exact);
        const auto filtered = material.filtered(BaseLobe::exact);
        const glm::dvec3 wi = direction(), wo = direction();
        const glm::dvec3 expected = eval(exact, wi, wo);
        const auto found = shader::lq_coated_eval(filtered, wi, wo);
        for (int c = 0; c < 3; ++c) {
            const double error = std::abs(found[c] - expected[c]);
            EXPECT_LE(error, kSecondOrder * material.lobe_error(exact, wi, wo, c) +
                                 1e-6 * (1.0 + expected[c]))
                << material.alpha << " " << material.eta << " " << material.tau[c];
            errors.push_back(relative(error, expected[c]));
        }
    }
    expect_usual_lobe_error(errors);
}

TEST_F(SamplerFilter, HardlyChangesTheGgxLobe) {
    std::vector<double> errors;
    for (int n = 0; n < kMaterials; ++n) {
        const Case material = next_case();
        const glm::dvec3 wi = direction(), wo = direction();
        const glm::dvec3 expected = eval(material.exact(BaseLobe::ggx), wi, wo);
        const auto found = shader::lq_coated_eval(material.filtered(BaseLobe::ggx), wi, wo);
        for (int c = 0; c < 3; ++c)
            errors.push_back(relative(std::abs(found[c] - expected[c]), expected[c]));
    }
    expect_usual_lobe_error(errors);
}

}  // namespace
}  // namespace lacquer::reference
