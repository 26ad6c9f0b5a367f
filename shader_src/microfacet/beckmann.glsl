// The Beckmann distribution of facet normals with Smith masking; anisotropic.
// Based on: Walter et al. 2007, Microfacet Models for Refraction through Rough Surfaces;
//           Heitz 2014, Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs
#ifndef LQ_MICROFACET_BECKMANN_GLSL
#define LQ_MICROFACET_BECKMANN_GLSL

#include "../core/math.glsl"

// exp of anything below this is 0 beside the smallest value that matters (1e-35 of the peak).
const float LQ_MIN_EXPONENT = -80.0;

// Slopes beyond this many standard widths are as good as never met: exp(-36) = 2e-16.
const float LQ_BECKMANN_MAX_SLOPE = 6.0;

// Halvings and Newton steps that bring a slope within 1e-7 of the root; Newton alone needs 4 to 6.
const int LQ_BECKMANN_MAX_STEPS = 24;

// Density of facet normals wm (unit, upper hemisphere) per solid angle and projected area.
// Heitz 2014, Eq. 82.
float lq_beckmann_density(const vec3 wm, const float alpha_x, const float alpha_y) {
    const float cos_squared = wm.z * wm.z;
    const float x = wm.x / alpha_x;
    const float y = wm.y / alpha_y;
    const float slope_squared = x * x + y * y;
    if (slope_squared >= -LQ_MIN_EXPONENT * cos_squared) {
        return 0.0;
    }
    return exp(-slope_squared / cos_squared) /
           (LQ_PI * alpha_x * alpha_y * cos_squared * cos_squared);
}

// Smith's Lambda times the cosine (Heitz 2014, Eq. 83), for w above the surface. With
// a = cot(theta) / alpha this is sin(theta) alpha ierfc(a) / 2, exact rather than the usual
// rational fit, and finite at grazing.
float lq_beckmann_projected_lambda(const vec3 w, const float alpha_x, const float alpha_y) {
    const float x = alpha_x * w.x;
    const float y = alpha_y * w.y;
    const float slope = sqrt(x * x + y * y);
    if (lq_square(w.z) >= -LQ_MIN_EXPONENT * slope * slope) {
        return 0.0;
    }
    const float a = w.z / slope;
    return 0.5 * slope * exp(-a * a) * lq_scaled_ierfc(a);
}

// erfc(x) / 2 for any x, from the scaled repeated integral.
float lq_half_erfc(const float x) {
    const float magnitude = abs(x);
    // x erfc(x) = exp(-x^2) / sqrt(pi) - ierfc(x) loses digits at small x, where the series serves.
    float tail = 0.0;
    if (magnitude < 0.5) {
        const float s = magnitude * magnitude;
        tail = 0.5 - magnitude * LQ_INVERSE_SQRT_PI *
                         (1.0 + s * (-0.333333333333333 + s * (0.1 + s * (-0.0238095238095238 +
                          s * (0.00462962962962963 - s * 0.000757575757575758)))));
    } else {
        tail = 0.5 * exp(-magnitude * magnitude) *
               (LQ_INVERSE_SQRT_PI - lq_scaled_ierfc(magnitude)) / magnitude;
    }
    return x < 0.0 ? 1.0 - tail : tail;
}

// Inverse of erf on (-1, 1).
// Based on: Giles 2012, Approximating the erfinv Function
float lq_erf_inverse(const float y) {
    const float w = -log(max((1.0 - y) * (1.0 + y), 1.0e-30));
    float p = 0.0;
    if (w < 5.0) {
        const float s = w - 2.5;
        p = 2.81022636e-08;
        p = 3.43273939e-07 + p * s;
        p = -3.5233877e-06 + p * s;
        p = -4.39150654e-06 + p * s;
        p = 0.00021858087 + p * s;
        p = -0.00125372503 + p * s;
        p = -0.00417768164 + p * s;
        p = 0.246640727 + p * s;
        p = 1.50140941 + p * s;
    } else {
        const float s = sqrt(w) - 3.0;
        p = -0.000200214257;
        p = 0.000100950558 + p * s;
        p = 0.00134934322 + p * s;
        p = -0.00367342844 + p * s;
        p = 0.00573950773 + p * s;
        p = -0.0076224613 + p * s;
        p = 0.00943887047 + p * s;
        p = 1.00167406 + p * s;
        p = 2.83297682 + p * s;
    }
    return p * y;
}

// Slope along the view direction of a visible facet of unit roughness, for a view at
// (sin_theta, cos_theta). A facet of slope s shows cos_theta - s sin_theta of its area, so that the
// distribution function over s up to the slope that hides, integrated by parts, is
//     G(s) = cos_theta erfc(-s) / 2 + sin_theta exp(-s^2) / (2 sqrt(pi)),
// growing by (cos_theta - s sin_theta) exp(-s^2) / sqrt(pi). Solves G(s) = u G(last slope) by
// Newton's method, kept inside a shrinking bracket.
float lq_beckmann_sample_visible_slope(const float sin_theta, const float cos_theta,
                                       const float u) {
    float low = -LQ_BECKMANN_MAX_SLOPE;
    float high = cos_theta < LQ_BECKMANN_MAX_SLOPE * sin_theta ? cos_theta / sin_theta
                                                              : LQ_BECKMANN_MAX_SLOPE;
    const float half_inverse_sqrt_pi = 0.5 * LQ_INVERSE_SQRT_PI;
    const float total = cos_theta * lq_half_erfc(-high) +
                        sin_theta * exp(-high * high) * half_inverse_sqrt_pi;
    const float wanted = u * total;
    float slope = min(0.0, 0.5 * (low + high));
    for (int count = 0; count < LQ_BECKMANN_MAX_STEPS; count++) {
        const float bell = exp(-slope * slope);
        const float value = cos_theta * lq_half_erfc(-slope) +
                            sin_theta * bell * half_inverse_sqrt_pi - wanted;
        if (value > 0.0) {
            high = slope;
        } else {
            low = slope;
        }
        const float growth = (cos_theta - slope * sin_theta) * bell * LQ_INVERSE_SQRT_PI;
        const float next = slope - value / max(growth, LQ_MIN_COSINE_PRODUCT);
        const float previous = slope;
        slope = next > low ? (next < high ? next : 0.5 * (low + high)) : 0.5 * (low + high);
        if (abs(slope - previous) < 1.0e-7) {
            break;
        }
    }
    return slope;
}

// Facet normal with the density of those visible from w (see lq_ggx_sample_visible_normal): the
// slope along the view by inversion, the slope across it by the inverse of erf, independent of it.
// Based on: Jakob 2014, An Improved Visible Normal Sampling Routine for the Beckmann Distribution
vec3 lq_beckmann_sample_visible_normal(const vec3 w, const float alpha_x, const float alpha_y,
                                       const vec2 u) {
    const vec3 stretched = normalize(vec3(alpha_x * w.x, alpha_y * w.y, w.z));
    const float sin_theta = sqrt(stretched.x * stretched.x + stretched.y * stretched.y);
    const float cos_phi = sin_theta > 0.0 ? stretched.x / sin_theta : 1.0;
    const float sin_phi = sin_theta > 0.0 ? stretched.y / sin_theta : 0.0;
    const float along = lq_beckmann_sample_visible_slope(sin_theta, stretched.z, u.x);
    const float across = lq_erf_inverse(2.0 * u.y - 1.0);
    const float slope_x = alpha_x * (cos_phi * along - sin_phi * across);
    const float slope_y = alpha_y * (sin_phi * along + cos_phi * across);
    return normalize(vec3(-slope_x, -slope_y, 1.0));
}

#endif
