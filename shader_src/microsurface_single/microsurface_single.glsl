// A rough surface whose roughness or metal changes with height (eroded, damaged, pitted, hazy), of
// light that met one of its facets: in closed form, but what meets several facets is missing.
// Based on: d'Eon et al. 2023, Microfacet Theory for Non-Uniform Heightfields
//
// Directions may be on either side of facets that refract. f is for radiance over the square of the
// index, which refraction keeps: f(wi, wo) over the squared index on the side of wi is symmetric.
#ifndef LQ_MICROSURFACE_SINGLE_MICROSURFACE_SINGLE_GLSL
#define LQ_MICROSURFACE_SINGLE_MICROSURFACE_SINGLE_GLSL

#include "../core/sampling.glsl"
#include "../core/shading.glsl"
#include "../microsurface/rough_surface.glsl"

// f(wi, wo), per steradian.
vec3 lq_microsurface_single_eval(const LqMicrosurfaceSurface surface, const vec3 wi,
                                 const vec3 wo) {
    if (!lq_microsurface_is_met(surface, wo)) {
        return vec3(0.0);
    }
    const LqRoughSide side = lq_microsurface_side(surface, wo);
    const vec3 light = lq_microsurface_frame(wi, wo);
    const vec3 viewer = lq_microsurface_frame(wo, wo);
    const vec3 crossings =
        lq_microsurface_crossing(surface, wi) * lq_microsurface_crossing(surface, wo);
    if (lq_is_above(light)) {
        return crossings * lq_reflected_once(side, light, viewer);
    }
    if (side.eta <= 0.0) {
        return vec3(0.0);
    }
    if (!lq_is_above(lq_mirrored(light))) {
        return vec3(0.0);
    }
    return crossings * lq_refracted_once(side, light, viewer);
}

// f(wi, wo) |cos_theta_i|.
vec3 lq_microsurface_single_eval_cos(const LqMicrosurfaceSurface surface, const vec3 wi,
                                     const vec3 wo) {
    return lq_microsurface_single_eval(surface, wi, wo) * abs(wi.z);
}

// Density per solid angle with which `lq_microsurface_single_sample` chooses wi.
float lq_microsurface_single_pdf(const LqMicrosurfaceSurface surface, const vec3 wi,
                                 const vec3 wo) {
    if (!lq_microsurface_is_met(surface, wo)) {
        return 0.0;
    }
    const LqRoughSide side = lq_microsurface_side(surface, wo);
    const vec3 light = lq_microsurface_frame(wi, wo);
    const vec3 viewer = lq_microsurface_frame(wo, wo);
    if (lq_is_above(light)) {
        return lq_reflected_pdf(side, light, viewer);
    }
    if (side.eta <= 0.0) {
        return 0.0;
    }
    if (!lq_is_above(lq_mirrored(light))) {
        return 0.0;
    }
    return lq_refracted_pdf(side, light, viewer);
}

// Direction of light for a viewer at wo, from three uniform numbers in [0, 1): the first chooses the
// stratum of a visible facet and whether it refracts, the others the facet.
LqSample lq_microsurface_single_sample(const LqMicrosurfaceSurface surface, const vec3 wo,
                                       const vec3 u) {
    if (!lq_microsurface_is_met(surface, wo)) {
        return LqSample(vec3(0.0, 0.0, 1.0), vec3(0.0), 0.0);
    }
    const LqRoughSide side = lq_microsurface_side(surface, wo);
    const vec3 viewer = lq_microsurface_frame(wo, wo);
    const LqVisibleNormal facet = lq_sample_visible_normal(side.strata, viewer, u);
    const float cos_theta = max(dot(viewer, facet.wm), 0.0);
    const bool refracts = side.eta > 0.0 &&
                          facet.rest >= lq_fresnel_dielectric(cos_theta, max(side.eta, LQ_MIN_ETA));
    const vec3 mirrored = facet.wm * (2.0 * cos_theta) - viewer;
    const vec3 light = refracts ? lq_refracted(viewer, facet.wm, side.eta) : mirrored;
    const vec3 wi = lq_microsurface_frame(light, wo);
    const bool is_lost = refracts ? light.z >= 0.0 : light.z <= 0.0;
    const float pdf = is_lost ? 0.0 : lq_microsurface_single_pdf(surface, wi, wo);
    if (pdf <= 0.0) {
        return LqSample(wi, vec3(0.0), 0.0);
    }
    return LqSample(wi, lq_microsurface_single_eval_cos(surface, wi, wo) * (1.0 / pdf), pdf);
}

// Fractions of the light from every direction that is sent to wo: by facets that refract, by a
// conductor (`base`), and from the other side; by averaging the weights of `point_count`
// low-discrepancy samples.
LqAlbedo lq_microsurface_single_albedo(const LqMicrosurfaceSurface surface, const vec3 wo,
                                       const int point_count) {
    if (surface.above.eta == 1.0 && wo.z != 0.0) {
        const vec3 straight = lq_microsurface_crossing(surface, vec3(0.0, 0.0, -abs(wo.z)));
        return LqAlbedo(vec3(0.0), vec3(0.0), straight);
    }
    vec3 reflected = vec3(0.0);
    vec3 refracted = vec3(0.0);
    const float share = 1.0 / float(max(point_count, 1));
    for (int index = 0; index < point_count; index++) {
        const vec2 square = lq_low_discrepancy_point(uint(index));
        const vec3 u = vec3((float(index) + 0.5) * share, square.x, square.y);
        const LqSample light = lq_microsurface_single_sample(surface, wo, u);
        if (light.wi.z * wo.z > 0.0) {
            reflected += share * light.weight;
        } else {
            refracted += share * light.weight;
        }
    }
    if (surface.above.eta > 0.0) {
        return LqAlbedo(reflected, vec3(0.0), refracted);
    }
    return LqAlbedo(vec3(0.0), reflected, vec3(0.0));
}

#endif
