// Lacquer 0.1.0, plain: a rough dielectric coat over a bare base, no light passing between them.
// Metal Shading Language 2.2, kernel 'eval'.
// SPDX-License-Identifier: Apache-2.0
// Generated; source sha256 d85ab33544d2164613bbf79196ca2f494ede51984bff525d6661fa7bb6164de9.

#include <metal_stdlib>

using namespace metal;

constant float LQ_PI = 3.1415927;
constant float LQ_INVERSE_PI = 0.31830987;

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

// A lobe is sampled at least this often where it reflects anything, so that weights stay bounded.
constant float LQ_MIN_CHOICE = 0.1;

// exp of anything below this is 0 beside the smallest value that matters (1e-35 of the peak).
constant float LQ_MIN_EXPONENT = -80.0;
constant int LQ_NDF_BECKMANN = 1;

// `ndf` is one of LQ_NDF_*; the alphas are slope roughnesses along x and y, in [LQ_MIN_ALPHA, 1].
struct LqFacets {
    int ndf;
    float alpha_x;
    float alpha_y;
};

// Keep 0 / 0 away: at exactly grazing incidence on a boundary without contrast, and at normal
// incidence on an index of 0, whose reflectance is 1 like that of any index near it.
constant float LQ_MIN_FRESNEL_COSINE = 1.0e-12;
constant float LQ_MIN_FRESNEL_TERM = 1.0e-30;

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

struct LqSurfaces {
    float4 rows[1];
};

struct LqInputs {
    float4 rows[1];
};

struct LqKernelParameters {
    uint query_count;
    uint queries_per_surface;
    uint point_count;
    uint reserved;
    float4 wo;
    float4 radiance;
};

struct LqResults {
    float4 rows[1];
};

// Row `index` of the packed surfaces: what unpacks them works for any buffer.
static inline float4 lq_packed_row(uint index, const device LqSurfaces& surfaces) {
    return surfaces.rows[index];
}

static inline float3 lq_input_vector(uint row, const device LqInputs& inputs) {
    return inputs.rows[row].xyz;
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

static inline float lq_square(float x) {
    return x * x;
}

static inline float lq_average(float3 v) {
    return (v.x + v.y + v.z) * 0.33333334;
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

// Density per solid angle of `lq_sample_cosine_hemisphere`.
static inline float lq_cosine_hemisphere_pdf(float cos_theta) {
    return max(cos_theta, 0.0) * LQ_INVERSE_PI;
}

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

// cos_theta_i cos_theta_o / G2(wi, wo), G2 = 1 / (1 + Lambda(wi) + Lambda(wo)): positive terms only.
static inline float lq_facets_cosines_over_masking_shadowing(LqFacets facets, float3 wi,
        float3 wo) {
    float lambda_i = lq_facets_projected_lambda(facets, wi);
    float lambda_o = lq_facets_projected_lambda(facets, wo);
    return max(wi.z * wo.z + wo.z * lambda_i + wi.z * lambda_o, LQ_MIN_COSINE_PRODUCT);
}

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

// The surface whose rows begin at `first`.
static inline LqOneCoat lq_one_coat_unpack(uint first, const device LqSurfaces& surfaces) {
    float4 coat = lq_packed_row(first, surfaces);
    float4 base = lq_packed_row(first + 1u, surfaces);
    float4 albedo = lq_packed_row(first + 2u, surfaces);
    float4 eta = lq_packed_row(first + 3u, surfaces);
    float4 kappa = lq_packed_row(first + 4u, surfaces);
    float4 optical_depth = lq_packed_row(first + 5u, surfaces);
    return LqOneCoat{ LqFacets{ int(coat.w), coat.x, coat.y }, coat.z, optical_depth.xyz,
        int(base.z), albedo.xyz, LqFacets{ int(base.w), base.x, base.y }, eta.xyz, kappa.xyz };
}

static inline LqOneCoat lq_model_surface(uint query, const device LqSurfaces& surfaces,
        constant LqKernelParameters& parameters) {
    uint row = query / parameters.queries_per_surface * 6u;
    return lq_plain_prepare(lq_one_coat_unpack(row, surfaces));
}

// Inputs: wi, wo per query. Results: (f, pdf).
kernel void main0(constant LqKernelParameters& parameters [[buffer(0)]],
        const device LqSurfaces& surfaces [[buffer(1)]],
        const device LqInputs& inputs [[buffer(2)]], device LqResults& results [[buffer(3)]],
        uint3 gl_GlobalInvocationID [[thread_position_in_grid]]) {
    uint query = gl_GlobalInvocationID.x;
    if (query >= parameters.query_count) {
        return;
    }
    LqOneCoat surface = lq_model_surface(query, surfaces, parameters);
    float3 wi = lq_input_vector(2u * query, inputs);
    float3 wo = lq_input_vector(2u * query + 1u, inputs);
    results.rows[query] = float4(lq_plain_eval(surface, wi, wo), lq_plain_pdf(surface, wi, wo));
}
