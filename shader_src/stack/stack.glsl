// Any stack of rough interfaces and media over a conductor, a Lambertian base or nothing, with all
// the light that goes back and forth in it: car paint, frosted and anodised metal, varnish.
// Based on: Belcour 2018, Efficient Rendering of Layered Materials using an Atomic Decomposition
//           with Statistical Operators; de Dinechin and Belcour 2022, Rendering Layered Materials
//           with Diffuse Interfaces
//
// Lobes follow from the viewer's direction alone and are not reciprocal (Belcour's forward model),
// but for the top interface's and a Lambertian base's.
#ifndef LQ_STACK_STACK_GLSL
#define LQ_STACK_STACK_GLSL

#include "../core/frame.glsl"
#include "../core/shading.glsl"
#include "choices.glsl"
#include "prepare.glsl"
#include "view.glsl"

// f(wi, wo) |cos_theta_i| for a viewer that `lq_stack_view` knows.
vec3 lq_stack_view_eval_cos(const LqStackSurface surface, const LqStackView viewer, const vec3 wi) {
    if (!lq_is_above(viewer.wo)) {
        return vec3(0.0);
    }
    return lq_stack_value(surface, viewer, wi) * abs(wi.z);
}

// f(wi, wo), per steradian; 0 unless wo is above the surface. Below it wi sees what a stack without
// a base lets through: for radiance over the square of the index, which refraction keeps.
vec3 lq_stack_eval(const LqStackSurface surface, const vec3 wi, const vec3 wo) {
    if (!lq_is_above(wo)) {
        return vec3(0.0);
    }
    return lq_stack_value(surface, lq_stack_view(surface, wo), wi);
}

// f(wi, wo) |cos_theta_i|.
vec3 lq_stack_eval_cos(const LqStackSurface surface, const vec3 wi, const vec3 wo) {
    return lq_stack_eval(surface, wi, wo) * abs(wi.z);
}

// Density per solid angle with which `lq_stack_sample` chooses wi; 0 unless wo is above the surface.
float lq_stack_pdf(const LqStackSurface surface, const vec3 wi, const vec3 wo) {
    if (!lq_is_above(wo)) {
        return 0.0;
    }
    return lq_stack_density(surface, lq_stack_view(surface, wo), wi);
}

// Direction of light for a viewer at wo, from three uniform numbers in [0, 1): the first chooses
// the lobe, the others the direction within it.
LqSample lq_stack_sample(const LqStackSurface surface, const vec3 wo, const vec3 u) {
    if (!lq_is_above(wo)) {
        return LqSample(vec3(0.0, 0.0, 1.0), vec3(0.0), 0.0);
    }
    const LqStackView viewer = lq_stack_view(surface, wo);
    const LqStackChoice chosen = lq_stack_direction(surface, viewer, u);
    const float pdf =
        chosen.is_of_its_lobe ? lq_stack_density(surface, viewer, chosen.wi) : 0.0;
    if (pdf <= 0.0) {
        return LqSample(chosen.wi, vec3(0.0), 0.0);
    }
    return LqSample(chosen.wi,
                    lq_stack_value(surface, viewer, chosen.wi) * (abs(chosen.wi.z) / pdf), pdf);
}

// Fraction of light from every direction that is sent to wo: by interfaces alone, by way of the
// base, and from below where no base is.
LqAlbedo lq_stack_albedo(const LqStackSurface surface, const vec3 wo) {
    if (!lq_is_above(wo)) {
        return lq_no_albedo();
    }
    return lq_stack_view_albedo(surface, lq_stack_view(surface, wo));
}

#endif
