// One rough surface of up to LQ_MAX_STRATA strata of facets: a bare conductor, or an interface with
// light on both sides.
#ifndef LQ_MICROSURFACE_ROUGH_SURFACE_GLSL
#define LQ_MICROSURFACE_ROUGH_SURFACE_GLSL

#include "../core/frame.glsl"
#include "single_scattering.glsl"

// `blend` one of LQ_BLEND_*; `count` strata from the top down, whose weights add up to 1: the last
// takes the rest. `eta` = index below over index above in [1/3, 3] of facets that refract, 0 of a
// conductor. `optical_depth` >= 0 of the medium below, along the normal.
struct LqMicrosurfaceMaterial {
    int blend;
    int count;
    float eta;
    vec3 optical_depth;
    LqStratum first;
    LqStratum second;
    LqStratum third;
    LqStratum fourth;
};

// `is_there`: a surface between equal indices is not.
struct LqMicrosurfaceSurface {
    LqRoughSide above;
    vec3 optical_depth;
    bool is_there;
};

bool lq_is_same_metal(const LqPlacedStratum a, const LqPlacedStratum b) {
    const vec3 apart = abs(a.eta - b.eta) + abs(a.kappa - b.kappa);
    return apart.x + apart.y + apart.z <= 0.0;
}

// The surface for shading: call it once per shading point. What is out of range is clamped.
LqMicrosurfaceSurface lq_microsurface_prepare(const LqMicrosurfaceMaterial material) {
    const int count = clamp(material.count, 1, LQ_MAX_STRATA);
    // C of the boundaries below the first three strata; 0 is the lowest.
    const float second =
        count > 1 ? clamp(1.0 - material.first.weight, 0.0, 1.0) : 0.0;
    const float third = count > 2 ? clamp(second - material.second.weight, 0.0, second) : 0.0;
    const float fourth = count > 3 ? clamp(third - material.third.weight, 0.0, third) : 0.0;
    LqMicrosurfaceSurface surface;
    surface.above.strata.blend = material.blend;
    surface.above.strata.count = count;
    surface.above.strata.first = lq_stratum_between(material.first, second, 1.0);
    surface.above.strata.second = lq_stratum_between(material.second, third, second);
    surface.above.strata.third = lq_stratum_between(material.third, fourth, third);
    surface.above.strata.fourth = lq_stratum_between(material.fourth, 0.0, fourth);
    surface.above.eta = material.eta > 0.0 ? clamp(material.eta, LQ_MIN_ETA, LQ_MAX_ETA) : 0.0;
    surface.above.is_one_metal =
        (count < 2 || lq_is_same_metal(surface.above.strata.first, surface.above.strata.second)) &&
        (count < 3 || lq_is_same_metal(surface.above.strata.first, surface.above.strata.third)) &&
        (count < 4 || lq_is_same_metal(surface.above.strata.first, surface.above.strata.fourth));
    surface.optical_depth =
        clamp(material.optical_depth, vec3(0.0), vec3(LQ_MAX_OPTICAL_DEPTH));
    surface.is_there = surface.above.eta != 1.0;
    return surface;
}

// A direction in the frame of the other side.
vec3 lq_mirrored(const vec3 w) {
    return vec3(w.x, w.y, -w.z);
}

// Where there is a surface for light along wo, from above or, of facets that refract, from below.
bool lq_microsurface_is_met(const LqMicrosurfaceSurface surface, const vec3 wo) {
    const bool refracts = surface.above.eta > 0.0;
    return surface.is_there && (lq_is_above(wo) || (refracts && lq_is_above(lq_mirrored(wo))));
}

LqRoughSide lq_microsurface_side(const LqMicrosurfaceSurface surface, const vec3 wo) {
    if (wo.z < 0.0) {
        return lq_rough_side_turned_over(surface.above);
    }
    return surface.above;
}

// w as seen from the side of wo: above there.
vec3 lq_microsurface_frame(const vec3 w, const vec3 wo) {
    return vec3(w.x, w.y, wo.z < 0.0 ? -w.z : w.z);
}

// What light along w leaves of itself to the medium below.
vec3 lq_microsurface_crossing(const LqMicrosurfaceSurface surface, const vec3 w) {
    if (w.z >= 0.0) {
        return vec3(1.0);
    }
    return exp(surface.optical_depth / min(w.z, -LQ_MIN_COSINE_PRODUCT));
}

#endif
