// Warps from the unit square, their densities, and the low-discrepancy points that feed them.
#ifndef LQ_CORE_SAMPLING_GLSL
#define LQ_CORE_SAMPLING_GLSL

#include "math.glsl"

// Direction on the upper hemisphere with density cos_theta / pi: a uniform point of the unit disk,
// lifted to the sphere (Malley's method).
vec3 lq_sample_cosine_hemisphere(const vec2 u) {
    const float radius = sqrt(u.x);
    const vec2 direction = lq_cos_sin_turn(u.y);
    return vec3(radius * direction.x, radius * direction.y, lq_safe_sqrt(1.0 - u.x));
}

// Density per solid angle of `lq_sample_cosine_hemisphere`.
float lq_cosine_hemisphere_pdf(const float cos_theta) {
    return max(cos_theta, 0.0) * LQ_INVERSE_PI;
}

// Point `index` (below 2^22) of the additive sequence whose steps are the powers of the inverse
// plastic number: low discrepancy for any number of points.
// Based on: Roberts 2018, The Unreasonable Effectiveness of Quasirandom Sequences
// The steps are 32-bit fractions, so that wrapping is exact integer arithmetic.
vec2 lq_low_discrepancy_point(const uint index) {
    const uint x = 2147483648u + (index + 1u) * 3242174889u;
    const uint y = 2147483648u + (index + 1u) * 2447445414u;
    return vec2(float(x >> 8u), float(y >> 8u)) * 5.9604644775390625e-08;
}

#endif
