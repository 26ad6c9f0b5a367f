// A rough coat over a Lambertian base with all the light that goes back and forth between them, for
// ceramics, plastics and lacquer: no energy is lost, and a light costs no table read.
// Based on: de Dinechin and Belcour 2022, Rendering Layered Materials with Diffuse Interfaces
#ifndef LQ_COATED_COATED_GLSL
#define LQ_COATED_COATED_GLSL

#include "../core/frame.glsl"
#include "../core/shading.glsl"
#include "base_lobe.glsl"
#include "coat_lobe.glsl"
#include "prefiltered.glsl"
#include "surface.glsl"

// f(wi, wo) cos_theta_i for a viewer that `lq_coated_view` knows; 0 unless wi is above the surface.
vec3 lq_coated_view_eval_cos(const LqCoatedSurface surface, const LqCoatedView viewer,
                             const vec3 wi) {
    if (!lq_is_above(wi)) {
        return vec3(0.0);
    }
    if (!lq_is_above(viewer.wo)) {
        return vec3(0.0);
    }
    return (lq_coated_base(surface, viewer, wi) + vec3(lq_coated_coat(surface, viewer, wi))) * wi.z;
}

// f(wi, wo), per steradian; 0 unless both directions are above the surface.
vec3 lq_coated_eval(const LqCoatedSurface surface, const vec3 wi, const vec3 wo) {
    if (!lq_is_above(wi)) {
        return vec3(0.0);
    }
    if (!lq_is_above(wo)) {
        return vec3(0.0);
    }
    const LqCoatedView viewer = lq_coated_view(surface, wo);
    return lq_coated_base(surface, viewer, wi) + vec3(lq_coated_coat(surface, viewer, wi));
}

// f(wi, wo) cos_theta_i.
vec3 lq_coated_eval_cos(const LqCoatedSurface surface, const vec3 wi, const vec3 wo) {
    return lq_coated_eval(surface, wi, wo) * max(wi.z, 0.0);
}

// How often `lq_coated_sample` chooses the coat: in proportion to what coat and base reflect.
float lq_coated_coat_choice(const LqCoatedView viewer) {
    const float base = lq_average(viewer.base);
    if (viewer.coat <= 0.0) {
        return 0.0;
    }
    if (base <= 0.0) {
        return 1.0;
    }
    return clamp(viewer.coat / (viewer.coat + base), LQ_MIN_CHOICE, 1.0 - LQ_MIN_CHOICE);
}

// Of the density per solid angle below, for directions above the surface.
float lq_coated_mixed_pdf(const LqCoatedSurface surface, const LqCoatedView viewer, const vec3 wi) {
    const float coat = lq_coated_coat_choice(viewer);
    return coat * lq_coated_coat_pdf(surface, viewer, wi) +
           (1.0 - coat) * lq_coated_base_pdf(surface, wi);
}

// Density per solid angle with which `lq_coated_sample` chooses wi; 0 unless both directions are
// above the surface.
float lq_coated_pdf(const LqCoatedSurface surface, const vec3 wi, const vec3 wo) {
    if (!lq_is_above(wi)) {
        return 0.0;
    }
    if (!lq_is_above(wo)) {
        return 0.0;
    }
    return lq_coated_mixed_pdf(surface, lq_coated_view(surface, wo), wi);
}

// Direction of light for a viewer at wo, from three uniform numbers in [0, 1): the first chooses
// the lobe, the others the direction within it.
LqSample lq_coated_sample(const LqCoatedSurface surface, const vec3 wo, const vec3 u) {
    if (!lq_is_above(wo)) {
        return LqSample(vec3(0.0, 0.0, 1.0), vec3(0.0), 0.0);
    }
    const LqCoatedView viewer = lq_coated_view(surface, wo);
    const vec2 square = vec2(u.y, u.z);
    const float coat = lq_coated_coat_choice(viewer);
    vec3 wi = vec3(0.0, 0.0, 1.0);
    if (u.x < coat) {
        wi = lq_coated_coat_sample(surface, viewer, u.x / coat, square);
    } else {
        wi = lq_coated_base_sample(surface, square);
    }
    if (!lq_is_above(wi)) {
        return LqSample(wi, vec3(0.0), 0.0);
    }
    const float pdf = lq_coated_mixed_pdf(surface, viewer, wi);
    if (pdf <= 0.0) {
        return LqSample(wi, vec3(0.0), 0.0);
    }
    return LqSample(wi, lq_coated_view_eval_cos(surface, viewer, wi) * (1.0 / pdf), pdf);
}

// Fraction of light from every direction that the coat and the base send to wo: the tables' own.
LqAlbedo lq_coated_albedo(const LqCoatedSurface surface, const vec3 wo) {
    if (!lq_is_above(wo)) {
        return lq_no_albedo();
    }
    const LqCoatedView viewer = lq_coated_view(surface, wo);
    return lq_opaque_albedo(vec3(viewer.coat), viewer.base);
}

#endif
