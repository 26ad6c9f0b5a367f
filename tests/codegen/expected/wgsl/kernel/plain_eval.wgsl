// Lacquer 0.1.0, plain: a rough dielectric coat over a bare base, no light passing between them.
// WGSL, kernel 'eval'.
// SPDX-License-Identifier: Apache-2.0
// Generated; source sha256 d85ab33544d2164613bbf79196ca2f494ede51984bff525d6661fa7bb6164de9.

const LQ_PI: f32 = 3.1415927;
const LQ_INVERSE_PI: f32 = 0.31830987;

// Lobes narrower than this are shaded at this width: a point light in a narrower one would land
// between the pixels, and the peak 1 / (pi alpha^2) stays well inside the range of a float.
const LQ_MIN_ALPHA: f32 = 0.001;

// The ranges of the material format: a value outside them is clamped by `prepare`.
const LQ_MIN_ETA: f32 = 0.33333334;
const LQ_MAX_ETA: f32 = 3.0;
const LQ_MAX_CONDUCTOR_INDEX: f32 = 40.0;

// exp(-80) is the smallest transmittance whose products are still normal floats.
const LQ_MAX_OPTICAL_DEPTH: f32 = 80.0;

// Below this a denominator that is a product of two cosines is raised, so that directions within
// 1e-15 of the horizon give a large value instead of infinity.
const LQ_MIN_COSINE_PRODUCT: f32 = 1.0e-30;

// A vector whose squared length lies outside these is no direction; formulas are bounded within.
const LQ_MIN_SQUARED_LENGTH: f32 = 0.5;
const LQ_MAX_SQUARED_LENGTH: f32 = 2.0;

// A lobe is sampled at least this often where it reflects anything, so that weights stay bounded.
const LQ_MIN_CHOICE: f32 = 0.1;

// exp of anything below this is 0 beside the smallest value that matters (1e-35 of the peak).
const LQ_MIN_EXPONENT: f32 = -80.0;
const LQ_NDF_BECKMANN: i32 = 1;

// `ndf` is one of LQ_NDF_*; the alphas are slope roughnesses along x and y, in [LQ_MIN_ALPHA, 1].
struct LqFacets {
    ndf: i32,
    alpha_x: f32,
    alpha_y: f32,
}

// Keep 0 / 0 away: at exactly grazing incidence on a boundary without contrast, and at normal
// incidence on an index of 0, whose reflectance is 1 like that of any index near it.
const LQ_MIN_FRESNEL_COSINE: f32 = 1.0e-12;
const LQ_MIN_FRESNEL_TERM: f32 = 1.0e-30;

// What lies below the coat, or is seen bare.
const LQ_BASE_NONE: i32 = 0;
const LQ_BASE_LAMBERTIAN: i32 = 1;
const LQ_BASE_CONDUCTOR: i32 = 2;

// `coat_eta` is the ior of the coat over that of the exterior, and 0 where there is no coat.
// `optical_depth` is that of the coat's medium along the normal, -log(tau): a logarithm taken on
// the host costs no digits here. `base` is one of LQ_BASE_*; `albedo` is read for a Lambertian
// base, the rest for a conductor, whose `eta + i kappa` is relative to the exterior.
struct LqOneCoat {
    coat: LqFacets,
    coat_eta: f32,
    optical_depth: vec3f,
    base: i32,
    albedo: vec3f,
    base_facets: LqFacets,
    eta: vec3f,
    kappa: vec3f,
}

struct LqSurfaces {
    rows: array<vec4f>,
}

struct LqInputs {
    rows: array<vec4f>,
}

struct LqKernelParameters {
    query_count: u32,
    queries_per_surface: u32,
    point_count: u32,
    reserved: u32,
    wo: vec4f,
    radiance: vec4f,
}

struct LqResults {
    rows: array<vec4f>,
}

@group(0) @binding(1) var<storage> surfaces: LqSurfaces;
@group(0) @binding(2) var<storage> inputs: LqInputs;
@group(0) @binding(0) var<uniform> parameters: LqKernelParameters;
@group(0) @binding(3) var<storage, read_write> results: LqResults;

// Row `index` of the packed surfaces: what unpacks them works for any buffer.
fn lq_packed_row(index: u32) -> vec4f {
    return surfaces.rows[index];
}

fn lq_input_vector(row: u32) -> vec3f {
    return inputs.rows[row].xyz;
}

// Whether `w` is a direction above the surface. False too for vectors far from unit length, whose
// formulas could overflow: what is not a direction reflects nothing.
fn lq_is_above(w: vec3f) -> bool {
    let length_squared = dot(w, w);
    if (length_squared < LQ_MIN_SQUARED_LENGTH) {
        return false;
    }
    var result: bool;
    if (w.z > 0.0) {
        result = length_squared < LQ_MAX_SQUARED_LENGTH;
    } else {
        result = false;
    }
    return result;
}

fn lq_square(x: f32) -> f32 {
    return x * x;
}

fn lq_average(v: vec3f) -> f32 {
    return (v.x + v.y + v.z) * 0.33333334;
}

// exp(x^2) times the first repeated integral of erfc, for x >= 0, to 3e-7 relative:
//     exp(x^2) ierfc(x) = 1 / sqrt(pi) - x exp(x^2) erfc(x).
// Polynomial in t = 1 / (1 + 0.4 x) by Chebyshev fit, t^2 carrying the decay 1 / (2 sqrt(pi) x^2).
// Written out it is 1 - 1 at large x; this form never subtracts what it is about to lose.
fn lq_scaled_ierfc(x: f32) -> f32 {
    let t = 1.0 / (1.0 + 0.4 * x);
    var sum = -0.039118025;
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
fn lq_cosine_hemisphere_pdf(cos_theta: f32) -> f32 {
    return max(cos_theta, 0.0) * LQ_INVERSE_PI;
}

// Density of facet normals wm (unit, upper hemisphere) per solid angle and projected area.
// Heitz 2014, Eq. 82.
fn lq_beckmann_density(wm: vec3f, alpha_x: f32, alpha_y: f32) -> f32 {
    let cos_squared = wm.z * wm.z;
    let x = wm.x / alpha_x;
    let y = wm.y / alpha_y;
    let slope_squared = x * x + y * y;
    if (slope_squared >= -LQ_MIN_EXPONENT * cos_squared) {
        return 0.0;
    }
    return exp(-slope_squared / cos_squared) /
        (LQ_PI * alpha_x * alpha_y * cos_squared * cos_squared);
}

// Smith's Lambda times the cosine (Heitz 2014, Eq. 83), for w above the surface. With
// a = cot(theta) / alpha this is sin(theta) alpha ierfc(a) / 2, exact rather than the usual
// rational fit, and finite at grazing.
fn lq_beckmann_projected_lambda(w: vec3f, alpha_x: f32, alpha_y: f32) -> f32 {
    let x = alpha_x * w.x;
    let y = alpha_y * w.y;
    let slope = sqrt(x * x + y * y);
    if (lq_square(w.z) >= -LQ_MIN_EXPONENT * slope * slope) {
        return 0.0;
    }
    let a = w.z / slope;
    return 0.5 * slope * exp(-a * a) * lq_scaled_ierfc(a);
}

// Density of facet normals wm (unit, upper hemisphere) per solid angle and projected area.
// Heitz 2014, Eq. 85.
fn lq_ggx_density(wm: vec3f, alpha_x: f32, alpha_y: f32) -> f32 {
    let x = wm.x / alpha_x;
    let y = wm.y / alpha_y;
    let sum = x * x + y * y + wm.z * wm.z;
    return 1.0 / (LQ_PI * alpha_x * alpha_y * sum * sum);
}

// Smith's Lambda times the cosine, cos_theta Lambda(w) (Heitz 2014, Eq. 86), for w above the
// surface. Unlike Lambda it stays finite at grazing, and in this form it loses no digits at normal
// incidence, where sqrt(1 + x) - 1 would.
fn lq_ggx_projected_lambda(w: vec3f, alpha_x: f32, alpha_y: f32) -> f32 {
    let x = alpha_x * w.x;
    let y = alpha_y * w.y;
    let slope_squared = x * x + y * y;
    let root = sqrt(slope_squared + w.z * w.z);
    return 0.5 * slope_squared / max(root + w.z, LQ_MIN_COSINE_PRODUCT);
}

// Facets with every parameter brought into its range.
fn lq_facets_prepare(ndf: i32, alpha_x: f32, alpha_y: f32) -> LqFacets {
    return LqFacets(ndf, clamp(alpha_x, LQ_MIN_ALPHA, 1.0), clamp(alpha_y, LQ_MIN_ALPHA, 1.0));
}

// D(wm), per solid angle; wm unit.
fn lq_facets_density(facets: LqFacets, wm: vec3f) -> f32 {
    if (facets.ndf == LQ_NDF_BECKMANN) {
        return lq_beckmann_density(wm, facets.alpha_x, facets.alpha_y);
    }
    return lq_ggx_density(wm, facets.alpha_x, facets.alpha_y);
}

// cos_theta Lambda(w): finite at grazing, where Lambda alone is not.
fn lq_facets_projected_lambda(facets: LqFacets, w: vec3f) -> f32 {
    if (facets.ndf == LQ_NDF_BECKMANN) {
        return lq_beckmann_projected_lambda(w, facets.alpha_x, facets.alpha_y);
    }
    return lq_ggx_projected_lambda(w, facets.alpha_x, facets.alpha_y);
}

// cos_theta_i cos_theta_o / G2(wi, wo), G2 = 1 / (1 + Lambda(wi) + Lambda(wo)): positive terms only.
fn lq_facets_cosines_over_masking_shadowing(facets: LqFacets, wi: vec3f, wo: vec3f) -> f32 {
    let lambda_i = lq_facets_projected_lambda(facets, wi);
    let lambda_o = lq_facets_projected_lambda(facets, wo);
    return max(wi.z * wo.z + wo.z * lambda_i + wi.z * lambda_o, LQ_MIN_COSINE_PRODUCT);
}

// Fresnel reflectance for cos_theta_i in [0, 1], eta = ior transmitted / ior incident; 1 beyond the
// critical angle.
//
// With g = eta cos_theta_t, g^2 = eta^2 - 1 + cos_theta_i^2, the amplitudes
//     r_s = (c - g) / (c + g),    r_p = (eta^2 c - g) / (eta^2 c + g)
// lose all digits in their numerators as eta nears 1. Multiplied by their own denominators these
// become (1 - eta^2) and (eta^2 - 1) (c^2 (eta^2 + 1) - 1), which do not.
fn lq_fresnel_dielectric(cos_theta_i: f32, eta: f32) -> f32 {
    let c = clamp(cos_theta_i, 0.0, 1.0);
    let contrast = (eta - 1.0) * (eta + 1.0);
    let g_squared = contrast + c * c;
    if (g_squared <= 0.0) {
        return 1.0;
    }
    let g = sqrt(g_squared);
    let denominator_s = c + g;
    let denominator_p = eta * eta * c + g;
    let amplitude_s = contrast / (denominator_s * denominator_s);
    let amplitude_p = contrast * (c * c * (eta * eta + 1.0) - 1.0) /
        (denominator_p * denominator_p);
    return min(0.5 * (amplitude_s * amplitude_s + amplitude_p * amplitude_p), 1.0);
}

// The facet normal that mirrors wo into wi, for both above the surface. Directions opposite along
// the horizon have none: the macroscopic normal stands in.
fn lq_halfway(wi: vec3f, wo: vec3f) -> vec3f {
    let sum = wi + wo;
    let length_squared = dot(sum, sum);
    if (length_squared < LQ_MIN_COSINE_PRODUCT) {
        return vec3f(0.0, 0.0, 1.0);
    }
    return sum * (1.0 / sqrt(length_squared));
}

// Cosine of the angle between either direction and their halfway normal. Half the length of the
// sum: for nearly opposite directions at grazing it keeps the digits that their dot product loses.
fn lq_cos_theta_halfway(wi: vec3f, wo: vec3f) -> f32 {
    return min(0.5 * length(wi + wo), 1.0);
}

// D G2 / (4 cos_theta_i cos_theta_o), per solid angle, for wi and wo above the surface. Walter et
// al. 2007, Eq. 20 without F.
fn lq_reflection_lobe(facets: LqFacets, wi: vec3f, wo: vec3f) -> f32 {
    let density = lq_facets_density(facets, lq_halfway(wi, wo));
    return 0.25 * density / lq_facets_cosines_over_masking_shadowing(facets, wi, wo);
}

// Density per solid angle of wi when the normals visible from wo mirror it:
// D_wo(wm) / (4 dot(wo, wm)) = D(wm) / (4 (cos_theta_o + cos_theta_o Lambda(wo))).
fn lq_reflection_pdf(facets: LqFacets, wi: vec3f, wo: vec3f) -> f32 {
    let density = lq_facets_density(facets, lq_halfway(wi, wo));
    let lambda_o = lq_facets_projected_lambda(facets, wo);
    return 0.25 * density / max(wo.z + lambda_o, LQ_MIN_COSINE_PRODUCT);
}

// Fresnel reflectance for cos_theta_i in [0, 1] and a conductor of index eta + i kappa (kappa >= 0)
// relative to the medium of incidence.
//
// The refracted normal component is (a + i b), with a^2 - b^2 = eta^2 - kappa^2 - sin^2 theta_i and
// a b = eta kappa. The difference is taken from 1 on both sides, or at grazing an index near the
// exterior's would leave nothing but rounding. The larger of a and b comes from a sum of positive terms and the other from the
// product: the textbook's difference of near-equal terms loses four digits for noble metals.
fn lq_fresnel_conductor(cos_theta_i: f32, eta: f32, kappa: f32) -> f32 {
    let c = clamp(cos_theta_i, LQ_MIN_FRESNEL_COSINE, 1.0);
    let sin_squared = (1.0 - c) * (1.0 + c);
    let difference = (eta - 1.0) * (eta + 1.0) - kappa * kappa + c * c;
    let product = eta * kappa;
    let larger =
        sqrt(0.5 * (sqrt(difference * difference + 4.0 * product * product) + abs(difference)));
    var smaller: f32;
    if (larger > 0.0) {
        smaller = product / larger;
    } else {
        smaller = 0.0;
    }
    let a = select(smaller, larger, difference >= 0.0);
    let b = select(larger, smaller, difference >= 0.0);
    let s_part = ((a - c) * (a - c) + b * b) / ((a + c) * (a + c) + b * b);
    let p_minus = a * c - sin_squared;
    let p_plus = a * c + sin_squared;
    let offset = b * b * c * c + LQ_MIN_FRESNEL_TERM;
    let p_part = (p_minus * p_minus + offset) / (p_plus * p_plus + offset);
    return min(0.5 * s_part * (1.0 + p_part), 1.0);
}

// The same for an index per colour channel.
fn lq_fresnel_conductor_rgb(cos_theta_i: f32, eta: vec3f, kappa: vec3f) -> vec3f {
    return vec3f(lq_fresnel_conductor(cos_theta_i, eta.x, kappa.x),
        lq_fresnel_conductor(cos_theta_i, eta.y, kappa.y),
        lq_fresnel_conductor(cos_theta_i, eta.z, kappa.z));
}

// The surface with every parameter brought into its range.
fn lq_one_coat_prepare(surface: LqOneCoat) -> LqOneCoat {
    var coat_eta: f32;
    if (surface.coat_eta > 0.0) {
        coat_eta = clamp(surface.coat_eta, LQ_MIN_ETA, LQ_MAX_ETA);
    } else {
        coat_eta = 0.0;
    }
    return LqOneCoat(
        lq_facets_prepare(surface.coat.ndf, surface.coat.alpha_x, surface.coat.alpha_y), coat_eta,
        clamp(surface.optical_depth, vec3f(0.0), vec3(LQ_MAX_OPTICAL_DEPTH)), surface.base,
        clamp(surface.albedo, vec3f(0.0), vec3f(1.0)),
        lq_facets_prepare(surface.base_facets.ndf, surface.base_facets.alpha_x,
        surface.base_facets.alpha_y), clamp(surface.eta, vec3f(0.0), vec3(LQ_MAX_CONDUCTOR_INDEX)),
        clamp(surface.kappa, vec3f(0.0), vec3(LQ_MAX_CONDUCTOR_INDEX)));
}

// The coat's single reflections, part of f.
fn lq_coat_lobe(surface: LqOneCoat, wi: vec3f, wo: vec3f) -> f32 {
    if (surface.coat_eta <= 0.0) {
        return 0.0;
    }
    return lq_fresnel_dielectric(lq_cos_theta_halfway(wi, wo), surface.coat_eta) *
        lq_reflection_lobe(surface.coat, wi, wo);
}

// What the base would reflect at this angle were it smooth, in a medium of ior `eta_above` over the
// exterior's: its albedo, or its Fresnel reflectance.
fn lq_base_reflectance(surface: LqOneCoat, cos_theta: f32, eta_above: f32) -> vec3f {
    if (surface.base == LQ_BASE_LAMBERTIAN) {
        return surface.albedo;
    }
    if (surface.base == LQ_BASE_CONDUCTOR) {
        let scale = 1.0 / eta_above;
        return lq_fresnel_conductor_rgb(cos_theta, surface.eta * scale, surface.kappa * scale);
    }
    return vec3f(0.0);
}

// The base's f, as if no coat lay over it, in a medium of ior `eta_above` over the exterior's.
fn lq_base_lobe(surface: LqOneCoat, wi: vec3f, wo: vec3f, eta_above: f32) -> vec3f {
    let reflectance = lq_base_reflectance(surface, lq_cos_theta_halfway(wi, wo), eta_above);
    if (surface.base == LQ_BASE_CONDUCTOR) {
        return reflectance * lq_reflection_lobe(surface.base_facets, wi, wo);
    }
    return reflectance * LQ_INVERSE_PI;
}

// Density of `lq_base_direction`.
fn lq_base_pdf(surface: LqOneCoat, wi: vec3f, wo: vec3f) -> f32 {
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
fn lq_coat_choice(surface: LqOneCoat, coat: f32, base: f32) -> f32 {
    if (surface.coat_eta <= 0.0) {
        return 0.0;
    }
    if (surface.base == LQ_BASE_NONE) {
        return 1.0;
    }
    return clamp(coat / (coat + base + LQ_MIN_COSINE_PRODUCT), LQ_MIN_CHOICE, 1.0 - LQ_MIN_CHOICE);
}

// Density per solid angle of `lq_one_coat_direction`.
fn lq_one_coat_pdf(surface: LqOneCoat, coat_choice: f32, wi: vec3f, wo: vec3f) -> f32 {
    var pdf = 0.0;
    if (coat_choice > 0.0) {
        pdf = coat_choice * lq_reflection_pdf(surface.coat, wi, wo);
    }
    return pdf + (1.0 - coat_choice) * lq_base_pdf(surface, wi, wo);
}

// The surface with every parameter brought into its range: call it once per shading point.
fn lq_plain_prepare(surface: LqOneCoat) -> LqOneCoat {
    return lq_one_coat_prepare(surface);
}

// f(wi, wo), per steradian; 0 unless both directions are above the surface. `surface` prepared.
fn lq_plain_eval(surface: LqOneCoat, wi: vec3f, wo: vec3f) -> vec3f {
    if (!lq_is_above(wi)) {
        return vec3f(0.0);
    }
    if (!lq_is_above(wo)) {
        return vec3f(0.0);
    }
    return lq_base_lobe(surface, wi, wo, 1.0) + vec3(lq_coat_lobe(surface, wi, wo));
}

// How often `lq_plain_sample` chooses the coat for this wo: in proportion to what the coat and the
// base would reflect were they smooth.
fn lq_plain_coat_choice(surface: LqOneCoat, wo: vec3f) -> f32 {
    return lq_coat_choice(surface, lq_fresnel_dielectric(wo.z, surface.coat_eta),
        lq_average(lq_base_reflectance(surface, wo.z, 1.0)));
}

// Density per solid angle with which `lq_plain_sample` chooses wi; 0 unless both directions are
// above the surface. `surface` prepared.
fn lq_plain_pdf(surface: LqOneCoat, wi: vec3f, wo: vec3f) -> f32 {
    if (!lq_is_above(wi)) {
        return 0.0;
    }
    if (!lq_is_above(wo)) {
        return 0.0;
    }
    return lq_one_coat_pdf(surface, lq_plain_coat_choice(surface, wo), wi, wo);
}

// The surface whose rows begin at `first`.
fn lq_one_coat_unpack(first: u32) -> LqOneCoat {
    let coat = lq_packed_row(first);
    let base = lq_packed_row(first + 1u);
    let albedo = lq_packed_row(first + 2u);
    let eta = lq_packed_row(first + 3u);
    let kappa = lq_packed_row(first + 4u);
    let optical_depth = lq_packed_row(first + 5u);
    return LqOneCoat(LqFacets(i32(coat.w), coat.x, coat.y), coat.z, optical_depth.xyz, i32(base.z),
        albedo.xyz, LqFacets(i32(base.w), base.x, base.y), eta.xyz, kappa.xyz);
}

fn lq_model_surface(query: u32) -> LqOneCoat {
    let row = query / parameters.queries_per_surface * 6u;
    return lq_plain_prepare(lq_one_coat_unpack(row));
}

// Inputs: wi, wo per query. Results: (f, pdf).
@compute @workgroup_size(64, 1, 1)
fn main(@builtin(global_invocation_id) gl_GlobalInvocationID: vec3u) {
    let query = gl_GlobalInvocationID.x;
    if (query >= parameters.query_count) {
        return;
    }
    let surface = lq_model_surface(query);
    let wi = lq_input_vector(2u * query);
    let wo = lq_input_vector(2u * query + 1u);
    results.rows[query] = vec4f(lq_plain_eval(surface, wi, wo), lq_plain_pdf(surface, wi, wo));
}
