// The stacks of ../stack, reciprocal: for bidirectional methods, and cheap per viewer and light,
// since all light is followed when the surface is prepared.
// Based on: Belcour 2018, Efficient Rendering of Layered Materials using an Atomic Decomposition
//           with Statistical Operators, section 6.2
#ifndef LQ_STACK_SYMMETRIC_STACK_SYMMETRIC_GLSL
#define LQ_STACK_SYMMETRIC_STACK_SYMMETRIC_GLSL

#include "../core/frame.glsl"
#include "../core/shading.glsl"
#include "../stack/choices.glsl"
#include "lobes.glsl"
#include "prepare.glsl"

// f(wi, wo) |cos_theta_i| for a viewer that `lq_stack_symmetric_view` knows.
vec3 lq_stack_symmetric_view_eval_cos(const LqStackSymmetricSurface surface,
                                      const LqStackSymmetricView viewer, const vec3 wi) {
    if (!lq_is_above(viewer.lobes.wo)) {
        return vec3(0.0);
    }
    return lq_stack_symmetric_value(surface, viewer, wi) * abs(wi.z);
}

// f(wi, wo), per steradian; 0 unless wo is above the surface. Below it wi sees what a stack without
// a base lets through: for radiance over the square of the index, which refraction keeps.
vec3 lq_stack_symmetric_eval(const LqStackSymmetricSurface surface, const vec3 wi, const vec3 wo) {
    if (!lq_is_above(wo)) {
        return vec3(0.0);
    }
    return lq_stack_symmetric_value(surface, lq_stack_symmetric_view(surface, wo), wi);
}

// f(wi, wo) |cos_theta_i|.
vec3 lq_stack_symmetric_eval_cos(const LqStackSymmetricSurface surface, const vec3 wi,
                                 const vec3 wo) {
    return lq_stack_symmetric_eval(surface, wi, wo) * abs(wi.z);
}

// Density per solid angle with which `lq_stack_symmetric_sample` chooses wi; 0 unless wo is above
// the surface.
float lq_stack_symmetric_pdf(const LqStackSymmetricSurface surface, const vec3 wi, const vec3 wo) {
    if (!lq_is_above(wo)) {
        return 0.0;
    }
    return lq_stack_density(surface.stack, lq_stack_symmetric_view(surface, wo).lobes, wi);
}

// Direction of light for a viewer at wo, from three uniform numbers in [0, 1): the first chooses
// the lobe, the others the direction within it.
LqSample lq_stack_symmetric_sample(const LqStackSymmetricSurface surface, const vec3 wo,
                                   const vec3 u) {
    if (!lq_is_above(wo)) {
        return LqSample(vec3(0.0, 0.0, 1.0), vec3(0.0), 0.0);
    }
    const LqStackSymmetricView viewer = lq_stack_symmetric_view(surface, wo);
    const LqStackChoice chosen = lq_stack_direction(surface.stack, viewer.lobes, u);
    const float pdf = chosen.is_of_its_lobe
                          ? lq_stack_density(surface.stack, viewer.lobes, chosen.wi)
                          : 0.0;
    if (pdf <= 0.0) {
        return LqSample(chosen.wi, vec3(0.0), 0.0);
    }
    return LqSample(
        chosen.wi,
        lq_stack_symmetric_value(surface, viewer, chosen.wi) * (abs(chosen.wi.z) / pdf), pdf);
}

// Fraction of light from every direction that is sent to wo: by interfaces alone, by way of the
// base, and from below where no base is.
LqAlbedo lq_stack_symmetric_albedo(const LqStackSymmetricSurface surface, const vec3 wo) {
    if (!lq_is_above(wo)) {
        return lq_no_albedo();
    }
    return lq_stack_view_albedo(surface.stack, lq_stack_symmetric_view(surface, wo).lobes);
}

#endif
