#include "reference/microsurface/microsurface_single.h"

#include <cmath>

namespace lacquer::reference {

SingleMicrosurface prepare_microsurface_single(const Material& material) {
    return {rough_surface(material, Model::microsurface_single)};
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
