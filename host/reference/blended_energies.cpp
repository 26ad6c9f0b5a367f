#include "reference/blended_energies.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/shading.h"
#include "reference/stack/directions.h"

namespace lacquer::reference {

namespace {

// Directions of equal weight that average over the hemisphere.
constexpr int kDirections = 12;

double node_angle(std::size_t node) {
    return std::numbers::pi * (static_cast<double>(node) + 0.5) / kCoefficients;
}

using Values = std::array<double, kCoefficients>;

Coefficients coefficients_through(const Values& values) {
    Coefficients coefficients{};
    for (std::size_t n = 0; n < kCoefficients; ++n) {
        for (std::size_t node = 0; node < kCoefficients; ++node)
            coefficients[n] += values[node] * std::cos(static_cast<double>(n) * node_angle(node));
        coefficients[n] *= (n == 0 ? 1.0 : 2.0) / kCoefficients;
    }
    return coefficients;
}

}  // namespace

Blend strata_of(const Roughness& roughness) {
    if (const auto* blend = std::get_if<Blend>(&roughness)) return *blend;
    return {Blend::Operator::asymmetric, {{1.0, std::get<Microsurface>(roughness), {}, {}, {}}}};
}

FacetStrata isotropic_strata(const Blend& blend, const std::vector<double>& alphas) {
    FacetStrata surface{blend.op, {}};
    double rest = 1.0;
    for (std::size_t k = 0; k < alphas.size(); ++k) {
        const double alpha = std::max(alphas[k], kMinAlpha);
        const double weight = k + 1 == alphas.size() ? rest : blend.strata[k].weight;
        surface.strata.push_back({weight, {Ndf::ggx, alpha, alpha}});
        rest -= weight;
    }
    return surface;
}

StratumShares first_met_at(const FacetStrata& surface, double cosine) {
    return first_met(surface, direction_of(std::max(cosine, kLeastCosine)));
}

StratumShares first_met_from_below(const FacetStrata& surface, double cosine) {
    StratumShares shares = first_met_at(turned_over(surface), cosine);
    std::ranges::reverse(shares);
    return shares;
}

DirectionPolynomial blended(const FacetStrata& surface, double critical, const OfStratum& value) {
    const auto sum_at = [&](double cosine) {
        const StratumShares first = first_met_at(surface, cosine);
        double sum = 0.0;
        for (std::size_t k = 0; k < first.size(); ++k) sum += first[k] * value(k, cosine);
        return sum;
    };
    Values below{}, above{};
    for (std::size_t node = 0; node < kCoefficients; ++node) {
        const double x = std::cos(node_angle(node));
        const double t_below = 0.5 * (1.0 - x), t_above = 0.5 * (1.0 + x);
        if (critical > 0.0) below[node] = sum_at(critical * (1.0 - t_below * t_below));
        above[node] = sum_at(critical + (1.0 - critical) * t_above * t_above);
    }
    return {critical, coefficients_through(below), coefficients_through(above)};
}

DirectionPolynomial blended(const FacetStrata& surface,
                            const std::vector<DirectionPolynomial>& of_strata) {
    if (of_strata.size() == 1) return of_strata.front();
    return blended(surface, of_strata.front().critical,
                   [&](std::size_t k, double cosine) { return of_strata[k].at(cosine); });
}

StratumShares first_met_by_diffuse_light(const FacetStrata& surface) {
    StratumShares mean(surface.strata.size(), 0.0);
    for (int n = 0; n < kDirections; ++n) {
        const StratumShares first =
            first_met_from_below(surface, std::sqrt((n + 0.5) / kDirections));
        for (std::size_t k = 0; k < mean.size(); ++k) mean[k] += first[k] / kDirections;
    }
    return mean;
}

}  // namespace lacquer::reference
