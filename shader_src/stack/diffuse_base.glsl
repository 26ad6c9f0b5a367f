// The light that comes back through a stack from a Lambertian base, exact but for the transport of
// the stack: since the base forgets directions and all above it is reciprocal,
//
//   f(wi, wo) = T(wi) T(wo) rho / (pi n^2 (1 - rho R_bar))
//
// with T(w) the light arriving along w that reaches the base for the first time, R_bar the light
// leaving the base diffusely that returns to it, and n the index above the base over the exterior's.
// Based on: de Dinechin and Belcour 2022, Rendering Layered Materials with Diffuse Interfaces, Eq. 3
#ifndef LQ_STACK_DIFFUSE_BASE_GLSL
#define LQ_STACK_DIFFUSE_BASE_GLSL

#include "beam.glsl"
#include "cubic.glsl"
#include "surface.glsl"

// Directions of equal weight that average T over the hemisphere.
const int LQ_ARRIVING_DIRECTIONS = 12;

// The share of light at cos_theta that the top interface lets in.
float lq_stack_entering(const LqStackSurface surface, const float cos_theta) {
    const vec4 cosines = vec4(cos_theta);
    if (surface.top_alpha < LQ_MIN_ALPHA) {
        return 1.0 - lq_fresnel_of_four(cosines, surface.top_eta).x;
    }
    const vec4 entering =
        lq_stack_side(surface.top_above, surface.top_critical, true, cosines) +
        lq_stack_side(surface.top_below, surface.top_critical, false, cosines);
    return clamp(entering.x, 0.0, 1.0);
}

// What a Lambertian base sends out: `arriving` is, of what the top interface lets in, the share that
// arrives at the base; `spread` is rho / (pi n^2 (1 - rho R_bar)), `returned` what of the light that
// has arrived leaves the stack.
struct LqStackDiffuse {
    LqCubic arriving;
    vec3 spread;
    vec3 returned;
};

// T of the three channels, and in w without absorption; cos_theta in [0, 1].
vec4 lq_stack_arriving(const LqStackSurface surface, const LqCubic arriving,
                       const float cos_theta) {
    return lq_stack_entering(surface, cos_theta) *
           clamp(lq_cubic_value(arriving, cos_theta), vec4(0.0), vec4(1.0));
}

// `returning` is what of diffuse light from the base comes back to it.
LqStackDiffuse lq_stack_diffuse(const LqStackSurface surface, const LqCubic arriving,
                                const vec4 returning) {
    vec4 mean = vec4(0.0);
    const int directions = surface.base == LQ_STACK_BASE_LAMBERTIAN ? LQ_ARRIVING_DIRECTIONS : 0;
    for (int n = 0; n < directions; n++) {
        const float u = (float(n) + 0.5) / float(LQ_ARRIVING_DIRECTIONS);
        mean += lq_stack_arriving(surface, arriving, sqrt(u)) / float(LQ_ARRIVING_DIRECTIONS);
    }
    // By reciprocity, what leaves of diffuse light from the base; no more than in clear media.
    const float fraction = 1.0 / (surface.index * surface.index);
    const vec4 leaving = min(mean * fraction, vec4(1.0));
    // Without absorption all that does not leave comes back: that keeps a white base white.
    const vec4 dimmed =
        min(returning / max(returning.w, LQ_TINY_LIGHT), vec4(1.0)) * (1.0 - leaving.w);
    const vec3 albedo = surface.base_albedo;
    const vec3 reflected = albedo / (vec3(1.0) - albedo * vec3(dimmed.x, dimmed.y, dimmed.z));
    const vec4 returned = min(leaving, vec4(leaving.w));
    return LqStackDiffuse(arriving, reflected * (LQ_INVERSE_PI * fraction),
                          reflected * vec3(returned.x, returned.y, returned.z));
}

#endif
