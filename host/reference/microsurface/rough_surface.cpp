#include "reference/microsurface/rough_surface.h"

#include <algorithm>
#include <cmath>
#include <glm/exponential.hpp>

#include "core/model_scope.h"
#include "reference/shading.h"

namespace lacquer::reference {

namespace {

Facets facets_of(const Microsurface& microsurface) {
    return {microsurface.ndf, std::max(microsurface.alpha[0], kMinAlpha),
            std::max(microsurface.alpha[1], kMinAlpha)};
}

// `index_of` gives the index of a stratum, which may hold its own.
template <typename IndexOf>
RoughSide side_of(const Roughness& roughness, const IndexOf& index_of) {
    if (const auto* uniform = std::get_if<Microsurface>(&roughness))
        return {{Blend::Operator::asymmetric, {{1.0, facets_of(*uniform)}}}, {index_of(Stratum{})}};
    const Blend& blend = std::get<Blend>(roughness);
    RoughSide side;
    side.facets.op = blend.op;
    double rest = 1.0;
    for (std::size_t k = 0; k < blend.strata.size(); ++k) {
        const Stratum& stratum = blend.strata[k];
        const double weight = k + 1 == blend.strata.size() ? rest : stratum.weight;
        rest -= weight;
        side.facets.strata.push_back({weight, facets_of(stratum.microsurface)});
        side.index.push_back(index_of(stratum));
    }
    return side;
}

RoughSide conductor_side(const ConductorBase& base, double exterior_ior) {
    return side_of(base.roughness, [&](const Stratum& stratum) {
        const Rgb eta = stratum.eta.value_or(base.eta);
        const Rgb kappa = stratum.kappa.value_or(base.kappa);
        FacetIndex index;
        for (std::size_t c = 0; c < 3; ++c)
            index[c] = std::complex{eta[c], kappa[c]} / exterior_ior;
        return index;
    });
}

glm::dvec3 transmittance_of(const Medium& medium) {
    if (const auto* absorbing = std::get_if<AbsorbingMedium>(&medium))
        return vector_of(absorbing->tau);
    const ScatteringMedium& scattering = std::get<ScatteringMedium>(medium);
    return glm::exp(-scattering.thickness * vector_of(scattering.sigma_a));
}

}  // namespace

RoughSide dielectric_side(const Interface& interface, double exterior_ior) {
    const double eta = interface.ior / exterior_ior;
    RoughSide side = side_of(interface.roughness, [&](const Stratum&) {
        return FacetIndex{eta, eta, eta};
    });
    side.refracts = true;
    return side;
}

RoughSurface rough_surface(const Material& material, Model model) {
    require_shadeable(material, model);
    if (const auto* conductor = std::get_if<ConductorBase>(&material.base))
        return {conductor_side(*conductor, material.exterior_ior), std::nullopt};
    const Layer& layer = material.layers.front();
    const RoughSide above = dielectric_side(layer.interface, material.exterior_ior);
    return {above, turned_over(above), transmittance_of(layer.medium), eta_of(above) != 1.0};
}

bool is_below(const glm::dvec3& w) {
    return w.z < 0.0;
}

Turned turned(const RoughSurface& surface, const glm::dvec3& wi, const glm::dvec3& wo) {
    if (!surface.is_there) return {};
    if (is_above(wo)) return {&surface.above, wi, wo};
    if (is_below(wo) && surface.below) return {&*surface.below, mirrored(wi), mirrored(wo)};
    return {};
}

glm::dvec3 crossing(const RoughSurface& surface, const glm::dvec3& w) {
    return is_below(w) ? glm::pow(surface.tau, glm::dvec3{1.0 / -w.z}) : glm::dvec3{1.0};
}

}  // namespace lacquer::reference
