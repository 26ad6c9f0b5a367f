#include "reference/microsurface/single_scattering.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "reference/fresnel.h"
#include "reference/microsurface/facet_integral.h"
#include "reference/microsurface/refraction.h"
#include "reference/microsurface/visible_normals.h"
#include "reference/reflection.h"

namespace lacquer::reference {

namespace {

glm::dvec3 reflectance(const FacetIndex& index, double cos_theta) {
    return {fresnel(cos_theta, index[0]), fresnel(cos_theta, index[1]),
            fresnel(cos_theta, index[2])};
}

// What a share per stratum makes of the density of normals.
double density_of(const FacetStrata& surface, const StratumShares& shares, const glm::dvec3& wm) {
    double sum = 0.0;
    for (std::size_t k = 0; k < shares.size(); ++k)
        sum += shares[k] * density(surface.strata[k].facets, wm);
    return sum;
}

// Light from wo that facets of this density send to wi, per solid angle. Walter et al. 2007,
// Eq. 15.
double refracted_density(const RoughSide& side, const StratumShares& shares, const glm::dvec3& wi,
                         const glm::dvec3& wo) {
    const double eta = eta_of(side);
    const auto wm = refraction_halfway(wi, wo, eta);
    if (!wm) return 0.0;
    const double cos_theta = glm::dot(wo, *wm);
    return (1.0 - fresnel(cos_theta, eta)) * density_of(side.facets, shares, *wm) * cos_theta /
           wo.z * refraction_jacobian(wi, wo, *wm, eta);
}

double crossing(double tau, double cosine) {
    return tau == 1.0 ? 1.0 : std::pow(tau, 1.0 / cosine);
}

// value(channel, tau) of each channel, once where all are the same.
template <typename Value>
glm::dvec3 per_channel(const RoughSide& side, const glm::dvec3& tau, const Value& value) {
    const double first = value(0, tau.x);
    if (side.refracts && tau.y == tau.x && tau.z == tau.x) return glm::dvec3{first};
    return {first, value(1, tau.y), value(2, tau.z)};
}

}  // namespace

RoughSide turned_over(const RoughSide& side) {
    RoughSide other{turned_over(side.facets), {side.index.rbegin(), side.index.rend()}, true};
    for (FacetIndex& index : other.index)
        for (std::complex<double>& eta : index) eta = 1.0 / eta;
    return other;
}

double eta_of(const RoughSide& side) {
    return side.index.front()[0].real();
}

glm::dvec3 mirrored(const glm::dvec3& w) {
    return {w.x, w.y, -w.z};
}

glm::dvec3 reflected_once(const RoughSide& side, const glm::dvec3& wi, const glm::dvec3& wo) {
    const glm::dvec3 wm = halfway(wi, wo);
    const double cos_theta = cos_theta_halfway(wi, wo);
    const StratumShares visible = masking_shadowing(side.facets, wi, wo);
    glm::dvec3 sum{0.0};
    for (std::size_t k = 0; k < visible.size(); ++k)
        sum += visible[k] * density(side.facets.strata[k].facets, wm) *
               reflectance(side.index[k], cos_theta);
    return sum / (4.0 * wi.z * wo.z);
}

double refracted_once(const RoughSide& side, const glm::dvec3& wi, const glm::dvec3& wo) {
    return refracted_density(side, masking_through(side.facets, wo, mirrored(wi)), wi, wo);
}

double reflected_pdf(const RoughSide& side, const glm::dvec3& wi, const glm::dvec3& wo) {
    // The visible density / (4 dot(wo, wm)), where the dot product cancels.
    const double density =
        density_of(side.facets, masking(side.facets, wo), halfway(wi, wo)) / (4.0 * wo.z);
    return side.refracts ? density * fresnel(cos_theta_halfway(wi, wo), eta_of(side)) : density;
}

double refracted_pdf(const RoughSide& side, const glm::dvec3& wi, const glm::dvec3& wo) {
    return refracted_density(side, masking(side.facets, wo), wi, wo);
}

FacetSample sample_facet(const RoughSide& side, const glm::dvec3& wo, const glm::dvec3& u) {
    const VisibleNormal visible = sample_visible_normal(side.facets, wo, u);
    const double cos_theta = glm::dot(wo, visible.wm);
    if (side.refracts && visible.u >= fresnel(cos_theta, eta_of(side))) {
        const auto wi = refracted(wo, visible.wm, eta_of(side));
        return wi ? FacetSample{*wi, true, wi->z >= 0.0} : FacetSample{wo, true, true};
    }
    const glm::dvec3 wi = 2.0 * cos_theta * visible.wm - wo;
    return {wi, false, !is_above(wi)};
}

glm::dvec3 reflected_share(const RoughSide& side, const glm::dvec3& wo, const glm::dvec3& tau) {
    const double eta = side.refracts ? eta_of(side) : HUGE_VAL;
    const TiltBreaks breaks = [&](const glm::dvec2& azimuth) {
        return reflecting_tilts(wo, azimuth, eta);
    };
    glm::dvec3 sum{0.0};
    for (std::size_t k = 0; k < side.index.size(); ++k)
        sum += per_channel(side, tau, [&](std::size_t channel, double channel_tau) {
            return facet_integral(side.facets.strata[k].facets, wo, breaks,
                                  [&](const glm::dvec3& wm, double cos_theta) {
                                      const glm::dvec3 wi = 2.0 * cos_theta * wm - wo;
                                      if (!is_above(wi)) return 0.0;
                                      return fresnel(cos_theta, side.index[k][channel]) *
                                             masking_shadowing(side.facets, wi, wo)[k] *
                                             crossing(channel_tau, wi.z);
                                  });
        });
    return sum;
}

glm::dvec3 refracted_share(const RoughSide& side, const glm::dvec3& wo, const glm::dvec3& tau) {
    const double eta = eta_of(side);
    const TiltBreaks breaks = [&](const glm::dvec2& azimuth) {
        return refracting_tilts(wo, azimuth, eta);
    };
    glm::dvec3 sum{0.0};
    for (std::size_t k = 0; k < side.index.size(); ++k)
        sum += per_channel(side, tau, [&](std::size_t, double channel_tau) {
            return facet_integral(side.facets.strata[k].facets, wo, breaks,
                                  [&](const glm::dvec3& wm, double cos_theta) {
                                      const auto wi = refracted(wo, wm, eta);
                                      if (!wi || wi->z >= 0.0) return 0.0;
                                      return (1.0 - fresnel(cos_theta, eta)) *
                                             masking_through(side.facets, wo, mirrored(*wi))[k] *
                                             crossing(channel_tau, -wi->z);
                                  });
        });
    return sum;
}

}  // namespace lacquer::reference
