#include "reference/microsurface/microsurface_single.h"

#include <algorithm>
#include <cmath>
#include <glm/exponential.hpp>

#include "core/model_scope.h"

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

RoughSide dielectric_side(const Interface& interface, double exterior_ior) {
    const double eta = interface.ior / exterior_ior;
    RoughSide side = side_of(interface.roughness, [&](const Stratum&) {
        return FacetIndex{eta, eta, eta};
    });
    side.refracts = true;
    return side;
}

glm::dvec3 transmittance_of(const Medium& medium) {
    if (const auto* absorbing = std::get_if<AbsorbingMedium>(&medium))
        return vector_of(absorbing->tau);
    const ScatteringMedium& scattering = std::get<ScatteringMedium>(medium);
    return glm::exp(-scattering.thickness * vector_of(scattering.sigma_a));
}

// A pair of directions in the frame of the side of wo.
struct Turned {
    const RoughSide* side = nullptr;  // nothing where there is no light
    glm::dvec3 wi, wo;
};

bool is_below(const glm::dvec3& w) {
    return w.z < 0.0;
}

Turned turned(const SingleMicrosurface& surface, const glm::dvec3& wi, const glm::dvec3& wo) {
    if (!surface.is_there) return {};
    if (is_above(wo)) return {&surface.above, wi, wo};
    if (is_below(wo) && surface.below) return {&*surface.below, mirrored(wi), mirrored(wo)};
    return {};
}

}  // namespace

glm::dvec3 crossing(const SingleMicrosurface& surface, const glm::dvec3& w) {
    return is_below(w) ? glm::pow(surface.tau, glm::dvec3{1.0 / -w.z}) : glm::dvec3{1.0};
}

SingleMicrosurface prepare_microsurface_single(const Material& material) {
    require_shadeable(material, Model::microsurface_single);
    if (const auto* conductor = std::get_if<ConductorBase>(&material.base))
        return {conductor_side(*conductor, material.exterior_ior), std::nullopt};
    const Layer& layer = material.layers.front();
    const RoughSide above = dielectric_side(layer.interface, material.exterior_ior);
    return {above, turned_over(above), transmittance_of(layer.medium), eta_of(above) != 1.0};
}

glm::dvec3 eval(const SingleMicrosurface& surface, const glm::dvec3& wi, const glm::dvec3& wo) {
    const Turned at = turned(surface, wi, wo);
    if (!at.side) return glm::dvec3{0.0};
    const glm::dvec3 crossings = crossing(surface, wi) * crossing(surface, wo);
    if (is_above(at.wi)) return crossings * reflected_once(*at.side, at.wi, at.wo);
    if (!is_below(at.wi) || !at.side->refracts) return glm::dvec3{0.0};
    return crossings * (refracted_once(*at.side, at.wi, at.wo) / -at.wi.z);
}

double pdf(const SingleMicrosurface& surface, const glm::dvec3& wi, const glm::dvec3& wo) {
    const Turned at = turned(surface, wi, wo);
    if (!at.side) return 0.0;
    if (is_above(at.wi)) return reflected_pdf(*at.side, at.wi, at.wo);
    const bool refracts = at.side->refracts && is_below(at.wi);
    return refracts ? refracted_pdf(*at.side, at.wi, at.wo) : 0.0;
}

Sample sample(const SingleMicrosurface& surface, const glm::dvec3& wo, const glm::dvec3& u) {
    Sample chosen;
    const Turned at = turned(surface, {}, wo);
    if (!at.side) return chosen;
    const FacetSample facet = sample_facet(*at.side, at.wo, u);
    chosen.wi = is_above(wo) ? facet.wi : mirrored(facet.wi);
    if (facet.is_lost) return chosen;
    chosen.pdf = pdf(surface, chosen.wi, wo);
    if (chosen.pdf > 0.0)
        chosen.weight = eval(surface, chosen.wi, wo) * std::abs(chosen.wi.z) / chosen.pdf;
    return chosen;
}

Albedo albedo(const SingleMicrosurface& surface, const glm::dvec3& wo) {
    Albedo light;
    if (!surface.is_there) {
        if (wo.z != 0.0) light.transmitted = crossing(surface, is_above(wo) ? -wo : wo);
        return light;
    }
    const Turned at = turned(surface, {}, wo);
    if (!at.side) return light;
    // Media are met on the way to the facet and on the way from it.
    const glm::dvec3 before = crossing(surface, wo), clear{1.0};
    const bool from_below = is_below(wo);
    const glm::dvec3 reflected =
        before * reflected_share(*at.side, at.wo, from_below ? surface.tau : clear);
    if (at.side->refracts) {
        light.direct = reflected;
        light.transmitted =
            before * refracted_share(*at.side, at.wo, from_below ? clear : surface.tau);
    } else {
        light.base = reflected;
    }
    return light;
}

}  // namespace lacquer::reference
