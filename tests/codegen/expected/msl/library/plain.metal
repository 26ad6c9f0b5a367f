// Lacquer 0.1.0, plain: a rough dielectric coat over a bare base, no light passing between them.
// Metal Shading Language 2.2, functions only, nothing bound.
// SPDX-License-Identifier: Apache-2.0
// Generated; source sha256 3ef0b3887ba32a3ae666ff20f633454a6c0bfa560b5530fa15af0ddf7579b6ba.
//
// Directions are unit vectors in a local frame whose z is the normal: wi towards the light, wo
// towards the viewer, wm a facet normal. f is the BSDF per steradian without the cosine; a name
// ending in _cos includes cos_theta_i. eta is ior below / ior above an interface, a conductor's
// index is eta + i kappa, alpha is the slope roughness of the papers.

#include <metal_stdlib>

using namespace metal;

// Numbers shared by every part of the library, and the limits that keep its formulas finite.

constant float LQ_PI = 3.1415927;
constant float LQ_INVERSE_PI = 0.31830987;
constant float LQ_INVERSE_SQRT_PI = 0.5641896;

// Lobes narrower than this are shaded at this width: a point light in a narrower one would land
// between the pixels, and the peak 1 / (pi alpha^2) stays well inside the range of a float.
constant float LQ_MIN_ALPHA = 0.001;

// The ranges of the material format: a value outside them is clamped by `prepare`.
constant float LQ_MIN_ETA = 0.33333334;
constant float LQ_MAX_ETA = 3.0;
constant float LQ_MAX_CONDUCTOR_INDEX = 40.0;

// exp(-80) is the smallest transmittance whose products are still normal floats.
constant float LQ_MAX_OPTICAL_DEPTH = 80.0;

// Below this a denominator that is a product of two cosines is raised, so that directions within
// 1e-15 of the horizon give a large value instead of infinity.
constant float LQ_MIN_COSINE_PRODUCT = 1.0e-30;

// A vector whose squared length lies outside these is no direction; formulas are bounded within.
constant float LQ_MIN_SQUARED_LENGTH = 0.5;
constant float LQ_MAX_SQUARED_LENGTH = 2.0;

// Orthonormal frames: every BSDF of the library works in a local frame whose z is the normal.
// Based on: Duff et al. 2017, Building an Orthonormal Basis, Revisited

struct LqFrame {
    float3 tangent;
    float3 bitangent;
    float3 normal;
};

// A frame about `normal` (unit), its tangent chosen without a branch in the normal's direction.
static inline LqFrame lq_frame_from_normal(float3 normal) {
    float side = normal.z < 0.0 ? -1.0 : 1.0;
    float a = -1.0 / (side + normal.z);
    float b = normal.x * normal.y * a;
    return LqFrame{ float3(1.0 + side * normal.x * normal.x * a, side * b, -side * normal.x),
        float3(b, side + normal.y * normal.y * a, -normal.y), normal };
}

// A frame about `normal` (unit) whose tangent is as near `tangent` as it can be; where the two are
// parallel, any tangent serves.
static inline LqFrame lq_frame_from_tangent(float3 normal, float3 tangent) {
    float3 across = cross(normal, tangent);
    float length_squared = dot(across, across);
    if (length_squared < 1.0e-12) {
        return lq_frame_from_normal(normal);
    }
    float3 bitangent = across * (1.0 / sqrt(length_squared));
    return LqFrame{ cross(bitangent, normal), bitangent, normal };
}

static inline float3 lq_frame_to_local(LqFrame frame, float3 w) {
    return float3(dot(w, frame.tangent), dot(w, frame.bitangent), dot(w, frame.normal));
}

static inline float3 lq_frame_to_world(LqFrame frame, float3 w) {
    return frame.tangent * w.x + frame.bitangent * w.y + frame.normal * w.z;
}

// Whether `w` is a direction above the surface. False too for vectors far from unit length, whose
// formulas could overflow: what is not a direction reflects nothing.
static inline bool lq_is_above(float3 w) {
    float length_squared = dot(w, w);
    if (length_squared < LQ_MIN_SQUARED_LENGTH) {
        return false;
    }
    return w.z > 0.0 ? length_squared < LQ_MAX_SQUARED_LENGTH : false;
}

// Scalar helpers, and replacements for built-in functions whose precision varies between drivers.
// No acos, asin, sin, cos or tanh is used anywhere in the library: drivers differ in them by up to
// 4e-4, a hundred times the difference that the library tolerates between languages.

static inline float lq_square(float x) {
    return x * x;
}

// Square root that treats a negative argument, which only rounding can produce, as 0.
static inline float lq_safe_sqrt(float x) {
    return sqrt(max(x, 0.0));
}

static inline float lq_average(float3 v) {
    return (v.x + v.y + v.z) * 0.33333334;
}

// sqrt(1 - x^2) without the cancellation of x near 1; x in [-1, 1].
static inline float lq_sine_from_cosine(float x) {
    return lq_safe_sqrt((1.0 - x) * (1.0 + x));
}

// (cos(2 pi turn), sin(2 pi turn)) for turn in [0, 1], to 2e-7.
// The turn is folded to within an eighth of an axis, where short Taylor series converge; folding is
// exact in binary, so that the error does not grow with the angle.
static inline float2 lq_cos_sin_turn(float turn) {
    float quarter = floor(4.0 * turn + 0.5);
    float angle = (turn - 0.25 * quarter) * (2.0 * LQ_PI);
    float s = angle * angle;
    float cosine = 1.0 + s *
        (-0.5 + s * (0.041666668 + s * (-0.0013888889 + s * (2.4801588e-5 - s * 2.755732e-7))));
    float sine = angle *
        (1.0 + s * (-0.16666667 + s * (0.008333334 + s * (-0.0001984127 + s * 2.7557319e-6))));
    if (quarter == 1.0) {
        return float2(-sine, cosine);
    }
    if (quarter == 2.0) {
        return float2(-cosine, -sine);
    }
    if (quarter == 3.0) {
        return float2(sine, -cosine);
    }
    return float2(cosine, sine);
}

// 2 artanh z for |z| <= 1/2, by its Taylor series, to a few roundings.
static inline float lq_twice_artanh(float z) {
    float s = z * z;
    float sum = 0.032258064;
    sum = sum * s + 0.03448276;
    sum = sum * s + 0.037037037;
    sum = sum * s + 0.04;
    sum = sum * s + 0.04347826;
    sum = sum * s + 0.04761905;
    sum = sum * s + 0.05263158;
    sum = sum * s + 0.05882353;
    sum = sum * s + 0.06666667;
    sum = sum * s + 0.07692308;
    sum = sum * s + 0.09090909;
    sum = sum * s + 0.11111111;
    sum = sum * s + 0.14285715;
    sum = sum * s + 0.2;
    sum = sum * s + 0.33333334;
    sum = sum * s + 1.0;
    return 2.0 * z * sum;
}

// Natural logarithm of x in [1/3, 3], to a few roundings: that of some drivers is off by 1e-6.
static inline float lq_log_ratio(float x) {
    return lq_twice_artanh((x - 1.0) / (x + 1.0));
}

// log(1 - y) for y in [0, 2/3], with all its digits near 0.
static inline float lq_log_complement(float y) {
    return lq_twice_artanh(-y / (2.0 - y));
}

// exp(x^2) times the first repeated integral of erfc, for x >= 0, to 3e-7 relative:
//     exp(x^2) ierfc(x) = 1 / sqrt(pi) - x exp(x^2) erfc(x).
// Polynomial in t = 1 / (1 + 0.4 x) by Chebyshev fit, t^2 carrying the decay 1 / (2 sqrt(pi) x^2).
// Written out it is 1 - 1 at large x; this form never subtracts what it is about to lose.
static inline float lq_scaled_ierfc(float x) {
    float t = 1.0 / (1.0 + 0.4 * x);
    float sum = -0.039118025;
    sum = sum * t + 0.2535899;
    sum = sum * t - 0.5745888;
    sum = sum * t + 0.49798867;
    sum = sum * t - 0.14689612;
    sum = sum * t + 0.18526737;
    sum = sum * t + 0.12720063;
    sum = sum * t + 0.12536448;
    sum = sum * t + 0.090246215;
    sum = sum * t + 0.045135286;
    return sum * t * t;
}

// Warps from the unit square, their densities, and the low-discrepancy points that feed them.

// Direction on the upper hemisphere with density cos_theta / pi: a uniform point of the unit disk,
// lifted to the sphere (Malley's method).
static inline float3 lq_sample_cosine_hemisphere(float2 u) {
    float radius = sqrt(u.x);
    float2 direction = lq_cos_sin_turn(u.y);
    return float3(radius * direction.x, radius * direction.y, lq_safe_sqrt(1.0 - u.x));
}

// Density per solid angle of `lq_sample_cosine_hemisphere`.
static inline float lq_cosine_hemisphere_pdf(float cos_theta) {
    return max(cos_theta, 0.0) * LQ_INVERSE_PI;
}

// Point `index` (below 2^22) of the additive sequence whose steps are the powers of the inverse
// plastic number: low discrepancy for any number of points.
// Based on: Roberts 2018, The Unreasonable Effectiveness of Quasirandom Sequences
// The steps are 32-bit fractions, so that wrapping is exact integer arithmetic.
static inline float2 lq_low_discrepancy_point(uint index) {
    uint x = 2147483648u + (index + 1u) * 3242174889u;
    uint y = 2147483648u + (index + 1u) * 2447445414u;
    return float2(float(x >> 8u), float(y >> 8u)) * 5.9604645e-8;
}

// What every model's `sample` and `albedo` return, and the terms on which lobes are chosen.

// `wi` unit, `weight` = f cos_theta_i / pdf, `pdf` per solid angle. A sample that reflects nothing
// has weight 0; its pdf is 0 where wi points below the surface.
struct LqSample {
    float3 wi;
    float3 weight;
    float pdf;
};

// A lobe is sampled at least this often where it reflects anything, so that weights stay bounded.
constant float LQ_MIN_CHOICE = 0.1;

// Directional albedo split by where the light turned back: at the coat or at the base; and what of
// the light goes through, where no base is.
struct LqAlbedo {
    float3 direct;
    float3 base;
    float3 transmitted;
};

static inline LqAlbedo lq_no_albedo() {
    return LqAlbedo{ float3(0.0), float3(0.0), float3(0.0) };
}

// Of a surface that lets nothing through.
static inline LqAlbedo lq_opaque_albedo(float3 direct, float3 base) {
    return LqAlbedo{ direct, base, float3(0.0) };
}

// Reflectance of a smooth boundary between a dielectric and a conductor, unpolarised light.
// Based on: Born and Wolf 1999, Principles of Optics, section 14.2

// Keep 0 / 0 away: at exactly grazing incidence on a boundary without contrast, and at normal
// incidence on an index of 0, whose reflectance is 1 like that of any index near it.
constant float LQ_MIN_FRESNEL_COSINE = 1.0e-12;
constant float LQ_MIN_FRESNEL_TERM = 1.0e-30;

// Fresnel reflectance for cos_theta_i in [0, 1] and a conductor of index eta + i kappa (kappa >= 0)
// relative to the medium of incidence.
//
// The refracted normal component is (a + i b), with a^2 - b^2 = eta^2 - kappa^2 - sin^2 theta_i and
// a b = eta kappa. The difference is taken from 1 on both sides, or at grazing an index near the
// exterior's would leave nothing but rounding. The larger of a and b comes from a sum of positive terms and the other from the
// product: the textbook's difference of near-equal terms loses four digits for noble metals.
static inline float lq_fresnel_conductor(float cos_theta_i, float eta, float kappa) {
    float c = clamp(cos_theta_i, LQ_MIN_FRESNEL_COSINE, 1.0);
    float sin_squared = (1.0 - c) * (1.0 + c);
    float difference = (eta - 1.0) * (eta + 1.0) - kappa * kappa + c * c;
    float product = eta * kappa;
    float larger =
        sqrt(0.5 * (sqrt(difference * difference + 4.0 * product * product) + abs(difference)));
    float smaller = larger > 0.0 ? product / larger : 0.0;
    float a = difference >= 0.0 ? larger : smaller;
    float b = difference >= 0.0 ? smaller : larger;
    float s_part = ((a - c) * (a - c) + b * b) / ((a + c) * (a + c) + b * b);
    float p_minus = a * c - sin_squared;
    float p_plus = a * c + sin_squared;
    float offset = b * b * c * c + LQ_MIN_FRESNEL_TERM;
    float p_part = (p_minus * p_minus + offset) / (p_plus * p_plus + offset);
    return min(0.5 * s_part * (1.0 + p_part), 1.0);
}

// The same for an index per colour channel.
static inline float3 lq_fresnel_conductor_rgb(float cos_theta_i, float3 eta, float3 kappa) {
    return float3(lq_fresnel_conductor(cos_theta_i, eta.x, kappa.x),
        lq_fresnel_conductor(cos_theta_i, eta.y, kappa.y),
        lq_fresnel_conductor(cos_theta_i, eta.z, kappa.z));
}

// Reflectance of a smooth boundary between two dielectrics, unpolarised light.
// Based on: Born and Wolf 1999, Principles of Optics, section 1.5

// Fresnel reflectance for cos_theta_i in [0, 1], eta = ior transmitted / ior incident; 1 beyond the
// critical angle.
//
// With g = eta cos_theta_t, g^2 = eta^2 - 1 + cos_theta_i^2, the amplitudes
//     r_s = (c - g) / (c + g),    r_p = (eta^2 c - g) / (eta^2 c + g)
// lose all digits in their numerators as eta nears 1. Multiplied by their own denominators these
// become (1 - eta^2) and (eta^2 - 1) (c^2 (eta^2 + 1) - 1), which do not.
static inline float lq_fresnel_dielectric(float cos_theta_i, float eta) {
    float c = clamp(cos_theta_i, 0.0, 1.0);
    float contrast = (eta - 1.0) * (eta + 1.0);
    float g_squared = contrast + c * c;
    if (g_squared <= 0.0) {
        return 1.0;
    }
    float g = sqrt(g_squared);
    float denominator_s = c + g;
    float denominator_p = eta * eta * c + g;
    float amplitude_s = contrast / (denominator_s * denominator_s);
    float amplitude_p = contrast * (c * c * (eta * eta + 1.0) - 1.0) /
        (denominator_p * denominator_p);
    return min(0.5 * (amplitude_s * amplitude_s + amplitude_p * amplitude_p), 1.0);
}

// 1 - `lq_fresnel_dielectric`, by the transmitted parts themselves: subtracted from 1, little of a
// transmittance near grazing would be left.
static inline float lq_transmittance_dielectric(float cos_theta_i, float eta) {
    float c = clamp(cos_theta_i, 0.0, 1.0);
    float g_squared = (eta - 1.0) * (eta + 1.0) + c * c;
    if (g_squared <= 0.0) {
        return 0.0;
    }
    float g = sqrt(g_squared);
    float denominator_s = c + g;
    float denominator_p = eta * eta * c + g;
    return min(
        2.0 * c * g * (
        1.0 / (denominator_s * denominator_s) + eta * eta / (denominator_p * denominator_p)), 1.0);
}

// cos_theta_t, the cosine between the refracted direction and the normal; 0 beyond the critical
// angle.
static inline float lq_refracted_cosine(float cos_theta_i, float eta) {
    float g_squared = (eta - 1.0) * (eta + 1.0) + cos_theta_i * cos_theta_i;
    return sqrt(max(g_squared, 0.0)) / eta;
}

// The Beckmann distribution of facet normals with Smith masking; anisotropic.
// Based on: Walter et al. 2007, Microfacet Models for Refraction through Rough Surfaces;
//           Heitz 2014, Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs

// exp of anything below this is 0 beside the smallest value that matters (1e-35 of the peak).
constant float LQ_MIN_EXPONENT = -80.0;

// Slopes beyond this many standard widths are as good as never met: exp(-36) = 2e-16.
constant float LQ_BECKMANN_MAX_SLOPE = 6.0;

// Halvings and Newton steps that bring a slope within 1e-7 of the root; Newton alone needs 4 to 6.
constant int LQ_BECKMANN_MAX_STEPS = 24;

// Density of facet normals wm (unit, upper hemisphere) per solid angle and projected area.
// Heitz 2014, Eq. 82.
static inline float lq_beckmann_density(float3 wm, float alpha_x, float alpha_y) {
    float cos_squared = wm.z * wm.z;
    float x = wm.x / alpha_x;
    float y = wm.y / alpha_y;
    float slope_squared = x * x + y * y;
    if (slope_squared >= -LQ_MIN_EXPONENT * cos_squared) {
        return 0.0;
    }
    return exp(-slope_squared / cos_squared) /
        (LQ_PI * alpha_x * alpha_y * cos_squared * cos_squared);
}

// Smith's Lambda times the cosine (Heitz 2014, Eq. 83), for w above the surface. With
// a = cot(theta) / alpha this is sin(theta) alpha ierfc(a) / 2, exact rather than the usual
// rational fit, and finite at grazing.
static inline float lq_beckmann_projected_lambda(float3 w, float alpha_x, float alpha_y) {
    float x = alpha_x * w.x;
    float y = alpha_y * w.y;
    float slope = sqrt(x * x + y * y);
    if (lq_square(w.z) >= -LQ_MIN_EXPONENT * slope * slope) {
        return 0.0;
    }
    float a = w.z / slope;
    return 0.5 * slope * exp(-a * a) * lq_scaled_ierfc(a);
}

// erfc(x) / 2 for any x, from the scaled repeated integral.
static inline float lq_half_erfc(float x) {
    float magnitude = abs(x);
    float tail = 0.0;
    if (magnitude < 0.5) {
        float s = magnitude * magnitude;
        tail = 0.5 - magnitude * LQ_INVERSE_SQRT_PI *
            (1.0 + s * (
            -0.33333334 + s * (0.1 + s * (-0.023809524 + s * (0.0046296297 - s * 0.00075757573)))));
    } else {
        tail = 0.5 * exp(-magnitude * magnitude) *
            (LQ_INVERSE_SQRT_PI - lq_scaled_ierfc(magnitude)) / magnitude;
    }
    return x < 0.0 ? 1.0 - tail : tail;
}

// Inverse of erf on (-1, 1).
// Based on: Giles 2012, Approximating the erfinv Function
static inline float lq_erf_inverse(float y) {
    float w = -log(max((1.0 - y) * (1.0 + y), 1.0e-30));
    float p = 0.0;
    if (w < 5.0) {
        float s = w - 2.5;
        p = 2.8102264e-8;
        p = 3.4327394e-7 + p * s;
        p = -3.5233877e-6 + p * s;
        p = -4.3915065e-6 + p * s;
        p = 0.00021858087 + p * s;
        p = -0.001253725 + p * s;
        p = -0.0041776816 + p * s;
        p = 0.24664073 + p * s;
        p = 1.5014094 + p * s;
    } else {
        float s = sqrt(w) - 3.0;
        p = -0.00020021426;
        p = 0.00010095056 + p * s;
        p = 0.0013493432 + p * s;
        p = -0.0036734284 + p * s;
        p = 0.0057395077 + p * s;
        p = -0.0076224613 + p * s;
        p = 0.0094388705 + p * s;
        p = 1.001674 + p * s;
        p = 2.8329768 + p * s;
    }
    return p * y;
}

// Slope along the view direction of a visible facet of unit roughness, for a view at
// (sin_theta, cos_theta). A facet of slope s shows cos_theta - s sin_theta of its area, so that the
// distribution function over s up to the slope that hides, integrated by parts, is
//     G(s) = cos_theta erfc(-s) / 2 + sin_theta exp(-s^2) / (2 sqrt(pi)),
// growing by (cos_theta - s sin_theta) exp(-s^2) / sqrt(pi). Solves G(s) = u G(last slope) by
// Newton's method, kept inside a shrinking bracket.
static inline float lq_beckmann_sample_visible_slope(float sin_theta, float cos_theta, float u) {
    float low = -LQ_BECKMANN_MAX_SLOPE;
    float high = cos_theta < LQ_BECKMANN_MAX_SLOPE * sin_theta ? cos_theta / sin_theta
        : LQ_BECKMANN_MAX_SLOPE;
    float half_inverse_sqrt_pi = 0.5 * LQ_INVERSE_SQRT_PI;
    float total = cos_theta * lq_half_erfc(-high) +
        sin_theta * exp(-high * high) * half_inverse_sqrt_pi;
    float wanted = u * total;
    float slope = min(0.0, 0.5 * (low + high));
    for (int count = 0; count < LQ_BECKMANN_MAX_STEPS; count++) {
        float bell = exp(-slope * slope);
        float value = cos_theta * lq_half_erfc(-slope) + sin_theta * bell * half_inverse_sqrt_pi -
            wanted;
        if (value > 0.0) {
            high = slope;
        } else {
            low = slope;
        }
        float growth = (cos_theta - slope * sin_theta) * bell * LQ_INVERSE_SQRT_PI;
        float next = slope - value / max(growth, LQ_MIN_COSINE_PRODUCT);
        float previous = slope;
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
static inline float3 lq_beckmann_sample_visible_normal(float3 w, float alpha_x, float alpha_y,
        float2 u) {
    float3 stretched = normalize(float3(alpha_x * w.x, alpha_y * w.y, w.z));
    float sin_theta = sqrt(stretched.x * stretched.x + stretched.y * stretched.y);
    float cos_phi = sin_theta > 0.0 ? stretched.x / sin_theta : 1.0;
    float sin_phi = sin_theta > 0.0 ? stretched.y / sin_theta : 0.0;
    float along = lq_beckmann_sample_visible_slope(sin_theta, stretched.z, u.x);
    float across = lq_erf_inverse(2.0 * u.y - 1.0);
    float slope_x = alpha_x * (cos_phi * along - sin_phi * across);
    float slope_y = alpha_y * (sin_phi * along + cos_phi * across);
    return normalize(float3(-slope_x, -slope_y, 1.0));
}

// The GGX (Trowbridge-Reitz) distribution of facet normals with Smith masking; anisotropic.
// Based on: Walter et al. 2007, Microfacet Models for Refraction through Rough Surfaces;
//           Heitz 2014, Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs

// Density of facet normals wm (unit, upper hemisphere) per solid angle and projected area.
// Heitz 2014, Eq. 85.
static inline float lq_ggx_density(float3 wm, float alpha_x, float alpha_y) {
    float x = wm.x / alpha_x;
    float y = wm.y / alpha_y;
    float sum = x * x + y * y + wm.z * wm.z;
    return 1.0 / (LQ_PI * alpha_x * alpha_y * sum * sum);
}

// Smith's Lambda times the cosine, cos_theta Lambda(w) (Heitz 2014, Eq. 86), for w above the
// surface. Unlike Lambda it stays finite at grazing, and in this form it loses no digits at normal
// incidence, where sqrt(1 + x) - 1 would.
static inline float lq_ggx_projected_lambda(float3 w, float alpha_x, float alpha_y) {
    float x = alpha_x * w.x;
    float y = alpha_y * w.y;
    float slope_squared = x * x + y * y;
    float root = sqrt(slope_squared + w.z * w.z);
    return 0.5 * slope_squared / max(root + w.z, LQ_MIN_COSINE_PRODUCT);
}

// Facet normal with the density of those visible from w:
//     D_w(wm) = max(0, dot(w, wm)) D(wm) / (cos_theta (1 + Lambda(w))).
// In the space where facets are spheres the visible normals are those halfway between w and a
// uniform point of a spherical cap.
// Based on: Dupuy and Benyoub 2023, Sampling Visible GGX Normals with Spherical Caps
static inline float3 lq_ggx_sample_visible_normal(float3 w, float alpha_x, float alpha_y,
        float2 u) {
    float3 stretched = normalize(float3(alpha_x * w.x, alpha_y * w.y, w.z));
    float2 direction = lq_cos_sin_turn(u.x);
    float height = (1.0 - u.y) * (1.0 + stretched.z) - stretched.z;
    float radius = lq_sine_from_cosine(clamp(height, -1.0, 1.0));
    float3 halfway = float3(radius * direction.x + stretched.x, radius * direction.y + stretched.y,
        max(height + stretched.z, LQ_MIN_COSINE_PRODUCT));
    return normalize(float3(alpha_x * halfway.x, alpha_y * halfway.y, halfway.z));
}

// A rough interface: a distribution of facet normals and its two roughnesses, with the operations
// that every lobe is made of. Smith masking, height-correlated.
// Based on: Heitz 2014, Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs

// Names of the distributions of facet normals.
constant int LQ_NDF_GGX = 0;
constant int LQ_NDF_BECKMANN = 1;

// `ndf` is one of LQ_NDF_*; the alphas are slope roughnesses along x and y, in [LQ_MIN_ALPHA, 1].
struct LqFacets {
    int ndf;
    float alpha_x;
    float alpha_y;
};

// Facets with every parameter brought into its range.
static inline LqFacets lq_facets_prepare(int ndf, float alpha_x, float alpha_y) {
    return LqFacets{ ndf, clamp(alpha_x, LQ_MIN_ALPHA, 1.0), clamp(alpha_y, LQ_MIN_ALPHA, 1.0) };
}

// D(wm), per solid angle; wm unit.
static inline float lq_facets_density(LqFacets facets, float3 wm) {
    if (facets.ndf == LQ_NDF_BECKMANN) {
        return lq_beckmann_density(wm, facets.alpha_x, facets.alpha_y);
    }
    return lq_ggx_density(wm, facets.alpha_x, facets.alpha_y);
}

// cos_theta Lambda(w): finite at grazing, where Lambda alone is not.
static inline float lq_facets_projected_lambda(LqFacets facets, float3 w) {
    if (facets.ndf == LQ_NDF_BECKMANN) {
        return lq_beckmann_projected_lambda(w, facets.alpha_x, facets.alpha_y);
    }
    return lq_ggx_projected_lambda(w, facets.alpha_x, facets.alpha_y);
}

// G1(w) = 1 / (1 + Lambda(w)): the fraction of facets not hidden from w.
static inline float lq_facets_masking(LqFacets facets, float3 w) {
    return w.z / max(w.z + lq_facets_projected_lambda(facets, w), LQ_MIN_COSINE_PRODUCT);
}

// cos_theta_i cos_theta_o / G2(wi, wo), G2 = 1 / (1 + Lambda(wi) + Lambda(wo)): positive terms only.
static inline float lq_facets_cosines_over_masking_shadowing(LqFacets facets, float3 wi,
        float3 wo) {
    float lambda_i = lq_facets_projected_lambda(facets, wi);
    float lambda_o = lq_facets_projected_lambda(facets, wo);
    return max(wi.z * wo.z + wo.z * lambda_i + wi.z * lambda_o, LQ_MIN_COSINE_PRODUCT);
}

// G2(wi, wo), the fraction of facets hidden from neither direction. Heitz 2014, Eq. 99.
static inline float lq_facets_masking_shadowing(LqFacets facets, float3 wi, float3 wo) {
    return wi.z * wo.z / lq_facets_cosines_over_masking_shadowing(facets, wi, wo);
}

// Facet normal with the density of those visible from w, for u in [0, 1)^2.
static inline float3 lq_facets_sample_visible_normal(LqFacets facets, float3 w, float2 u) {
    if (facets.ndf == LQ_NDF_BECKMANN) {
        return lq_beckmann_sample_visible_normal(w, facets.alpha_x, facets.alpha_y, u);
    }
    return lq_ggx_sample_visible_normal(w, facets.alpha_x, facets.alpha_y, u);
}

// Light reflected once by a facet: the Cook-Torrance lobe without its Fresnel factor.
// Based on: Walter et al. 2007, Microfacet Models for Refraction through Rough Surfaces

// The facet normal that mirrors wo into wi, for both above the surface. Directions opposite along
// the horizon have none: the macroscopic normal stands in.
static inline float3 lq_halfway(float3 wi, float3 wo) {
    float3 sum = wi + wo;
    float length_squared = dot(sum, sum);
    if (length_squared < LQ_MIN_COSINE_PRODUCT) {
        return float3(0.0, 0.0, 1.0);
    }
    return sum * (1.0 / sqrt(length_squared));
}

// Cosine of the angle between either direction and their halfway normal. Half the length of the
// sum: for nearly opposite directions at grazing it keeps the digits that their dot product loses.
static inline float lq_cos_theta_halfway(float3 wi, float3 wo) {
    return min(0.5 * length(wi + wo), 1.0);
}

// D G2 / (4 cos_theta_i cos_theta_o), per solid angle, for wi and wo above the surface. Walter et
// al. 2007, Eq. 20 without F.
static inline float lq_reflection_lobe(LqFacets facets, float3 wi, float3 wo) {
    float density = lq_facets_density(facets, lq_halfway(wi, wo));
    return 0.25 * density / lq_facets_cosines_over_masking_shadowing(facets, wi, wo);
}

// Density per solid angle of wi when the normals visible from wo mirror it:
// D_wo(wm) / (4 dot(wo, wm)) = D(wm) / (4 (cos_theta_o + cos_theta_o Lambda(wo))).
static inline float lq_reflection_pdf(LqFacets facets, float3 wi, float3 wo) {
    float density = lq_facets_density(facets, lq_halfway(wi, wo));
    float lambda_o = lq_facets_projected_lambda(facets, wo);
    return 0.25 * density / max(wo.z + lambda_o, LQ_MIN_COSINE_PRODUCT);
}

// wo mirrored by a normal visible from it. May point below the surface: such light meets another
// facet, which a lobe of single reflections leaves out.
static inline float3 lq_reflection_sample(LqFacets facets, float3 wo, float2 u) {
    float3 wm = lq_facets_sample_visible_normal(facets, wo, u);
    return wm * (2.0 * dot(wo, wm)) - wo;
}

// The surface that the simple models shade: an optional dielectric coat over a Lambertian base or a
// conductor.

// What lies below the coat, or is seen bare.
constant int LQ_BASE_NONE = 0;
constant int LQ_BASE_LAMBERTIAN = 1;
constant int LQ_BASE_CONDUCTOR = 2;

// `coat_eta` is the ior of the coat over that of the exterior, and 0 where there is no coat.
// `optical_depth` is that of the coat's medium along the normal, -log(tau): a logarithm taken on
// the host costs no digits here. `base` is one of LQ_BASE_*; `albedo` is read for a Lambertian
// base, the rest for a conductor, whose `eta + i kappa` is relative to the exterior.
struct LqOneCoat {
    LqFacets coat;
    float coat_eta;
    float3 optical_depth;
    int base;
    float3 albedo;
    LqFacets base_facets;
    float3 eta;
    float3 kappa;
};

// The surface with every parameter brought into its range.
static inline LqOneCoat lq_one_coat_prepare(LqOneCoat surface) {
    float coat_eta = surface.coat_eta > 0.0 ? clamp(surface.coat_eta, LQ_MIN_ETA, LQ_MAX_ETA) : 0.0;
    return LqOneCoat{
        lq_facets_prepare(surface.coat.ndf, surface.coat.alpha_x, surface.coat.alpha_y), coat_eta,
        clamp(surface.optical_depth, float3(0.0), float3(LQ_MAX_OPTICAL_DEPTH)), surface.base,
        clamp(surface.albedo, float3(0.0), float3(1.0)),
        lq_facets_prepare(surface.base_facets.ndf, surface.base_facets.alpha_x,
        surface.base_facets.alpha_y),
        clamp(surface.eta, float3(0.0), float3(LQ_MAX_CONDUCTOR_INDEX)),
        clamp(surface.kappa, float3(0.0), float3(LQ_MAX_CONDUCTOR_INDEX)) };
}

// What the models of one coat share: the coat's single reflections, the base's lobe, and choosing a
// direction from either. Surfaces are prepared; wi and wo are above the surface.
// Based on: Walter et al. 2007, Microfacet Models for Refraction through Rough Surfaces

// The coat's single reflections, part of f.
static inline float lq_coat_lobe(LqOneCoat surface, float3 wi, float3 wo) {
    if (surface.coat_eta <= 0.0) {
        return 0.0;
    }
    return lq_fresnel_dielectric(lq_cos_theta_halfway(wi, wo), surface.coat_eta) *
        lq_reflection_lobe(surface.coat, wi, wo);
}

// What the base would reflect at this angle were it smooth, in a medium of ior `eta_above` over the
// exterior's: its albedo, or its Fresnel reflectance.
static inline float3 lq_base_reflectance(LqOneCoat surface, float cos_theta, float eta_above) {
    if (surface.base == LQ_BASE_LAMBERTIAN) {
        return surface.albedo;
    }
    if (surface.base == LQ_BASE_CONDUCTOR) {
        float scale = 1.0 / eta_above;
        return lq_fresnel_conductor_rgb(cos_theta, surface.eta * scale, surface.kappa * scale);
    }
    return float3(0.0);
}

// The base's f, as if no coat lay over it, in a medium of ior `eta_above` over the exterior's.
static inline float3 lq_base_lobe(LqOneCoat surface, float3 wi, float3 wo, float eta_above) {
    float3 reflectance = lq_base_reflectance(surface, lq_cos_theta_halfway(wi, wo), eta_above);
    if (surface.base == LQ_BASE_CONDUCTOR) {
        return reflectance * lq_reflection_lobe(surface.base_facets, wi, wo);
    }
    return reflectance * LQ_INVERSE_PI;
}

// Density of `lq_base_direction`.
static inline float lq_base_pdf(LqOneCoat surface, float3 wi, float3 wo) {
    if (surface.base == LQ_BASE_LAMBERTIAN) {
        return lq_cosine_hemisphere_pdf(wi.z);
    }
    if (surface.base == LQ_BASE_CONDUCTOR) {
        return lq_reflection_pdf(surface.base_facets, wi, wo);
    }
    return 0.0;
}

// A direction in which the base reflects, from two uniform numbers: wo mirrored by a visible facet,
// or by the cosine. May point below the surface.
static inline float3 lq_base_direction(LqOneCoat surface, float3 wo, float2 u) {
    if (surface.base == LQ_BASE_CONDUCTOR) {
        return lq_reflection_sample(surface.base_facets, wo, u);
    }
    return lq_sample_cosine_hemisphere(u);
}

// How often a direction is chosen from the coat where it reflects the fraction `coat` and the base
// the fraction `base`.
static inline float lq_coat_choice(LqOneCoat surface, float coat, float base) {
    if (surface.coat_eta <= 0.0) {
        return 0.0;
    }
    if (surface.base == LQ_BASE_NONE) {
        return 1.0;
    }
    return clamp(coat / (coat + base + LQ_MIN_COSINE_PRODUCT), LQ_MIN_CHOICE, 1.0 - LQ_MIN_CHOICE);
}

// Density per solid angle of `lq_one_coat_direction`.
static inline float lq_one_coat_pdf(LqOneCoat surface, float coat_choice, float3 wi, float3 wo) {
    float pdf = 0.0;
    if (coat_choice > 0.0) {
        pdf = coat_choice * lq_reflection_pdf(surface.coat, wi, wo);
    }
    return pdf + (1.0 - coat_choice) * lq_base_pdf(surface, wi, wo);
}

// Direction of light for a viewer at wo, from three uniform numbers in [0, 1): the first chooses
// the coat with probability `coat_choice`, or the base; the others the direction within its lobe.
// May point below the surface.
static inline float3 lq_one_coat_direction(LqOneCoat surface, float coat_choice, float3 wo,
        float3 u) {
    float2 square = u.yz;
    if (u.x < coat_choice) {
        return lq_reflection_sample(surface.coat, wo, square);
    }
    return lq_base_direction(surface, wo, square);
}

// The fraction of facets seen from wo whose mirrored light no other facet hides, for a direction of
// `lq_reflection_sample`: its lobe without F, times cos_theta_i, over its density.
static inline float lq_shown_fraction(LqFacets facets, float3 wi, float3 wo) {
    if (!lq_is_above(wi)) {
        return 0.0;
    }
    return lq_facets_masking_shadowing(facets, wi, wo) / lq_facets_masking(facets, wo);
}

// Directional albedo of `lq_coat_lobe`, by averaging `point_count` low-discrepancy samples.
static inline float lq_coat_albedo(LqOneCoat surface, float3 wo, int point_count) {
    if (surface.coat_eta <= 0.0) {
        return 0.0;
    }
    float share = 1.0 / float(max(point_count, 1));
    float albedo = 0.0;
    for (int index = 0; index < point_count; index++) {
        float2 square = lq_low_discrepancy_point(uint(index));
        float3 wi = lq_reflection_sample(surface.coat, wo, square);
        albedo += share * lq_shown_fraction(surface.coat, wi, wo) *
            lq_fresnel_dielectric(lq_cos_theta_halfway(wi, wo), surface.coat_eta);
    }
    return albedo;
}

// `lq_base_lobe` times cos_theta_i over `lq_base_pdf`, for a direction of `lq_base_direction`.
static inline float3 lq_base_weight(LqOneCoat surface, float3 wi, float3 wo, float eta_above) {
    float3 reflectance = lq_base_reflectance(surface, lq_cos_theta_halfway(wi, wo), eta_above);
    if (surface.base == LQ_BASE_CONDUCTOR) {
        return reflectance * lq_shown_fraction(surface.base_facets, wi, wo);
    }
    return reflectance;
}

// Directional albedo of `lq_base_lobe` below the exterior, a conductor's by averaging `point_count`
// low-discrepancy samples.
static inline float3 lq_base_albedo(LqOneCoat surface, float3 wo, int point_count) {
    if (surface.base != LQ_BASE_CONDUCTOR) {
        return lq_base_reflectance(surface, wo.z, 1.0);
    }
    float share = 1.0 / float(max(point_count, 1));
    float3 albedo = float3(0.0);
    for (int index = 0; index < point_count; index++) {
        float3 wi = lq_base_direction(surface, wo, lq_low_discrepancy_point(uint(index)));
        albedo += lq_base_weight(surface, wi, wo, 1.0) * share;
    }
    return albedo;
}

// The shading that most engines do today: the coat's single reflections plus the base as if it were
// bare. No light passes from one to the other, so a coated base is too bright and nothing keeps
// energy; it is the baseline that the layered models are measured against. The coat's medium does
// not absorb.
// Based on: Walter et al. 2007, Microfacet Models for Refraction through Rough Surfaces

// The surface with every parameter brought into its range: call it once per shading point.
static inline LqOneCoat lq_plain_prepare(LqOneCoat surface) {
    return lq_one_coat_prepare(surface);
}

// f(wi, wo), per steradian; 0 unless both directions are above the surface. `surface` prepared.
static inline float3 lq_plain_eval(LqOneCoat surface, float3 wi, float3 wo) {
    if (!lq_is_above(wi)) {
        return float3(0.0);
    }
    if (!lq_is_above(wo)) {
        return float3(0.0);
    }
    return lq_base_lobe(surface, wi, wo, 1.0) + float3(lq_coat_lobe(surface, wi, wo));
}

// f(wi, wo) cos_theta_i.
static inline float3 lq_plain_eval_cos(LqOneCoat surface, float3 wi, float3 wo) {
    return lq_plain_eval(surface, wi, wo) * max(wi.z, 0.0);
}

// How often `lq_plain_sample` chooses the coat for this wo: in proportion to what the coat and the
// base would reflect were they smooth.
static inline float lq_plain_coat_choice(LqOneCoat surface, float3 wo) {
    return lq_coat_choice(surface, lq_fresnel_dielectric(wo.z, surface.coat_eta),
        lq_average(lq_base_reflectance(surface, wo.z, 1.0)));
}

// Density per solid angle with which `lq_plain_sample` chooses wi; 0 unless both directions are
// above the surface. `surface` prepared.
static inline float lq_plain_pdf(LqOneCoat surface, float3 wi, float3 wo) {
    if (!lq_is_above(wi)) {
        return 0.0;
    }
    if (!lq_is_above(wo)) {
        return 0.0;
    }
    return lq_one_coat_pdf(surface, lq_plain_coat_choice(surface, wo), wi, wo);
}

// Direction of light for a viewer at wo, from three uniform numbers in [0, 1): the first chooses
// the lobe, the others the direction within it. `surface` prepared.
static inline LqSample lq_plain_sample(LqOneCoat surface, float3 wo, float3 u) {
    if (!lq_is_above(wo)) {
        return LqSample{ float3(0.0, 0.0, 1.0), float3(0.0), 0.0 };
    }
    float coat_choice = lq_plain_coat_choice(surface, wo);
    float3 wi = lq_one_coat_direction(surface, coat_choice, wo, u);
    float pdf = lq_plain_pdf(surface, wi, wo);
    if (pdf <= 0.0) {
        return LqSample{ wi, float3(0.0), 0.0 };
    }
    return LqSample{ wi, lq_plain_eval_cos(surface, wi, wo) * (1.0 / pdf), pdf };
}

// Fraction of light from every direction that the coat and the base send to wo, by averaging
// `point_count` low-discrepancy samples of each (256 give about three digits). `surface` prepared.
static inline LqAlbedo lq_plain_albedo(LqOneCoat surface, float3 wo, int point_count) {
    if (!lq_is_above(wo)) {
        return lq_no_albedo();
    }
    return lq_opaque_albedo(float3(lq_coat_albedo(surface, wo, point_count)),
        lq_base_albedo(surface, wo, point_count));
}
