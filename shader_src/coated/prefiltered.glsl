// The base's light under an environment, for the base lobe `exact`: T01 as a function of the light's
// cos_theta in three functions, so that three prefiltered maps carry it, as one carries irradiance.
// The lobe `ggx` is lit by maps prefiltered with GGX instead.
//
// The functions are 1, 3 c - 2 and 10 c^2 - 12 c + 3, c = cos_theta: orthogonal in c dc over [0, 1], so
// that the total is exact under light from everywhere. Map k holds the integral, over the directions
// above a normal, of radiance times function k times cos_theta. For eta >= 1 that misplaces 0.004 of
// the light in the mean and 0.02 at most. For eta < 1 T01 has an edge at the critical angle, which
// three functions blur: 0.12 in the mean, most of the light where next to none gets in.
#ifndef LQ_COATED_PREFILTERED_GLSL
#define LQ_COATED_PREFILTERED_GLSL

#include "surface.glsl"

// T01 of the colour channels: mean + slope (3 c - 2) + curvature (10 c^2 - 12 c + 3).
struct LqCoatedProfile {
    vec3 mean;
    vec3 slope;
    vec3 curvature;
};

// Of T01 of the colour channels over directions, weighted as lq_direction_weights says.
vec3 lq_coated_integral(const LqCoatedSurface surface, const vec4 below, const vec4 above) {
    const vec4 integrals = lq_direction_integrals(surface.energies.transmission,
                                                  lq_direction_weights(below, above));
    return vec3(integrals.x, integrals.y, integrals.z);
}

// T01 in three functions of the light's cos_theta, for `lq_coated_base_prefiltered`: call it once per
// shading point.
LqCoatedProfile lq_coated_profile(const LqCoatedSurface surface) {
    const float critical = surface.energies.critical;
    const float rest = 1.0 - critical;
    // Integrals of T01 c dc, c^2 dc and c^3 dc: polynomials of t^2 (interface/polynomial.glsl).
    const float below = critical * critical;
    const vec4 entering = surface.energies.entering;
    const vec3 first = vec3(entering.x, entering.y, entering.z);
    const vec3 second = lq_coated_integral(
        surface, below * critical * vec4(1.0, -2.0, 1.0, 0.0),
        rest * vec4(below, 2.0 * critical * rest, rest * rest, 0.0));
    const vec3 third = lq_coated_integral(
        surface, below * below * vec4(1.0, -3.0, 3.0, -1.0),
        rest * vec4(below * critical, 3.0 * below * rest, 3.0 * critical * rest * rest,
                    rest * rest * rest));
    return LqCoatedProfile(2.0 * first, 4.0 * (3.0 * second - 2.0 * first),
                           6.0 * (10.0 * third - 12.0 * second + 3.0 * first));
}

// Radiance of the base's light towards a viewer, from what the three maps hold at the normal.
vec3 lq_coated_base_prefiltered(const LqCoatedSurface surface, const LqCoatedView viewer,
                                const LqCoatedProfile profile, const vec3 mean,
                                const vec3 slope, const vec3 curvature) {
    const vec3 light =
        profile.mean * mean + profile.slope * slope + profile.curvature * curvature;
    return viewer.entering * surface.spread * max(light, vec3(0.0));
}

#endif
