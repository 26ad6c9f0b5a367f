#include "reference/microsurface/facet_strata.h"

#include <algorithm>
#include <cmath>

#include "reference/microsurface/incomplete_beta.h"

namespace lacquer::reference {

namespace {

bool is_mixed(const FacetStrata& surface) {
    return surface.op == Blend::Operator::symmetric;
}

// `whole`, visible of a surface that is the same at every height, divided among its strata.
StratumShares divided(const FacetStrata& surface, double whole) {
    StratumShares shares;
    for (const FacetStratum& stratum : surface.strata) shares.push_back(stratum.weight * whole);
    return shares;
}

// Where a stratum lies, in C(h).
struct Extent {
    double low, high;
};

std::vector<Extent> extents_of(const FacetStrata& surface) {
    std::vector<Extent> extents;
    double high = 1.0;
    for (const FacetStratum& stratum : surface.strata) {
        const double low = std::max(high - stratum.weight, 0.0);
        extents.push_back({low, high});
        high = low;
    }
    extents.back().low = 0.0;
    return extents;
}

// Of rays from below a stratum, or from above it on the other side, which pass it.
double passed(double from, double to, double lambda) {
    return lambda > 0.0 ? std::pow(from / to, lambda) : 1.0;
}

// A ray leaves from height c within a stratum with the probability (c / high)^Lambda; rays in two
// directions leave independently, as if their Lambdas were one: the integral over c is
//     high (1 - (low / high)^(1 + Lambda)) / (1 + Lambda).
StratumShares visible(const FacetStrata& surface, const std::vector<double>& lambdas) {
    const std::vector<Extent> extents = extents_of(surface);
    StratumShares shares;
    double unhidden = 1.0;  // by the strata above
    for (std::size_t k = 0; k < extents.size(); ++k) {
        const auto [low, high] = extents[k];
        const double exponent = 1.0 + lambdas[k];
        const double hidden = std::expm1(exponent * std::log(low / high));
        shares.push_back(unhidden * high * -hidden / exponent);
        unhidden *= passed(low, high, lambdas[k]);
    }
    return shares;
}

std::vector<double> lambdas_of(const FacetStrata& surface, const glm::dvec3& w) {
    std::vector<double> lambdas;
    for (const FacetStratum& stratum : surface.strata) lambdas.push_back(lambda(stratum.facets, w));
    return lambdas;
}

}  // namespace

FacetStrata turned_over(FacetStrata surface) {
    std::ranges::reverse(surface.strata);
    return surface;
}

double density(const FacetStrata& surface, const glm::dvec3& wm) {
    double sum = 0.0;
    for (const FacetStratum& stratum : surface.strata)
        sum += stratum.weight * density(stratum.facets, wm);
    return sum;
}

double lambda(const FacetStrata& surface, const glm::dvec3& w) {
    double sum = 0.0;
    for (const FacetStratum& stratum : surface.strata)
        sum += stratum.weight * lambda(stratum.facets, w);
    return sum;
}

double projected_area(const FacetStrata& surface, const glm::dvec3& w) {
    return w.z * (1.0 + lambda(surface, w));
}

StratumShares masking(const FacetStrata& surface, const glm::dvec3& w) {
    if (is_mixed(surface)) return divided(surface, 1.0 / (1.0 + lambda(surface, w)));
    return visible(surface, lambdas_of(surface, w));
}

StratumShares first_met(const FacetStrata& surface, const glm::dvec3& w) {
    if (surface.strata.size() == 1) return {1.0};
    StratumShares shares = masking(surface, w);
    for (std::size_t k = 0; k < shares.size(); ++k)
        shares[k] *= 1.0 + lambda(surface.strata[k].facets, w);
    return shares;
}

StratumShares masking_shadowing(const FacetStrata& surface, const glm::dvec3& wi,
                                const glm::dvec3& wo) {
    if (is_mixed(surface))
        return divided(surface, 1.0 / (1.0 + lambda(surface, wi) + lambda(surface, wo)));
    std::vector<double> both = lambdas_of(surface, wi);
    for (std::size_t k = 0; k < both.size(); ++k) both[k] += lambda(surface.strata[k].facets, wo);
    return visible(surface, both);
}

StratumShares masking_through(const FacetStrata& surface, const glm::dvec3& above,
                              const glm::dvec3& below) {
    if (is_mixed(surface))
        return divided(surface,
                       beta_between(0.0, 1.0, lambda(surface, above), lambda(surface, below)));
    const std::vector<Extent> extents = extents_of(surface);
    const std::vector<double> upwards = lambdas_of(surface, above);
    const std::vector<double> downwards = lambdas_of(surface, below);
    StratumShares shares;
    double unhidden = 1.0;
    for (std::size_t k = 0; k < extents.size(); ++k) {
        const auto [low, high] = extents[k];
        shares.push_back(unhidden * beta_between(low, high, upwards[k], downwards[k]));
        unhidden *= passed(low, high, upwards[k]);
    }
    unhidden = 1.0;
    for (std::size_t k = extents.size(); k-- > 0;) {
        const auto [low, high] = extents[k];
        shares[k] *= unhidden;
        unhidden *= passed(1.0 - high, 1.0 - low, downwards[k]);
    }
    return shares;
}

}  // namespace lacquer::reference
