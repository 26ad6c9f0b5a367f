// OpenPBR's coat: below the coat's single reflections lies the base, made rougher by the coat,
// darkened by the light that goes back and forth below it, attenuated along the refracted paths and
// scaled by what the coat does not reflect to the viewer. Not reciprocal. Without a coat it is the
// base.
// Based on: OpenPBR Surface specification 1.1, sections on layering and on the coat
// (coat_weight 1, coat_darkening 1)
// Differs: the coat's directional albedo E_coat is taken as the Fresnel reflectance of a smooth
// coat, where the specification leaves the choice between tables and sampling; and paths through
// the coat are at most 1 / LQ_OPENPBR_MIN_COSINE long, also beyond the critical angle of coat_eta
// below 1, where the specification's are imaginary.
#ifndef LQ_OPENPBR_COAT_OPENPBR_COAT_GLSL
#define LQ_OPENPBR_COAT_OPENPBR_COAT_GLSL

#include "../one_coat/lobes.glsl"

// Keeps paths along the coat finite.
const float LQ_OPENPBR_MIN_COSINE = 0.0333333333333333;

// `surface` has the base's roughness below the coat, and indices relative to the coat. `base_albedo` is the base's at normal
// incidence, `base_roughness` its perceptual roughness without the coat, 1 for a Lambertian.
// `diffuse_escape` = 1 - K_r is the fraction of diffuse light from below that leaves the coat.
struct LqOpenpbrCoat {
    LqOneCoat surface;
    vec3 base_albedo;
    float base_roughness;
    float diffuse_escape;
};

// Fresnel reflectance averaged over the cosine-weighted hemisphere, for eta in [1, 3]: the fit that
// the specification takes from d'Eon 2021, log(p / q) with p = 10893 eta - 1438.2 and q = -774.4
// eta^2 + 10212 eta + 1, as the series of 2 atanh((p - q) / (p + q)), which needs no log. It stops
// at 1e-9.
float lq_openpbr_average_fresnel(const float eta) {
    const float y = ((774.4 * eta + 681.0) * eta - 1439.2) /
                    ((-774.4 * eta + 21105.0) * eta - 1437.2);
    const float s = y * y;
    return 2.0 * y *
           (1.0 + s * (0.333333333333333 + s * (0.2 + s * (0.142857142857143 +
                                                           s * 0.111111111111111))));
}

// 1 - K_r for a coat of this eta: K_r = 1 - (1 - E_F(eta)) / eta^2, and below 1, where
// E_F(eta) = 1 - eta^2 (1 - E_F(1 / eta)), it is E_F(1 / eta).
float lq_openpbr_diffuse_escape(const float eta) {
    if (eta < 1.0) {
        return 1.0 - lq_openpbr_average_fresnel(1.0 / eta);
    }
    return (1.0 - lq_openpbr_average_fresnel(eta)) / (eta * eta);
}

// Facets with the variance of slopes that `below` and, twice, `above` have: light passes the coat's
// twice. In perceptual roughness r, whose fourth power is a variance, r' = min(1, r^4 + 2
// r_coat^4)^(1/4).
LqFacets lq_openpbr_roughen(const LqFacets below, const LqFacets above) {
    const float x_squared = below.alpha_x * below.alpha_x;
    const float y_squared = below.alpha_y * below.alpha_y;
    const float variance = 0.5 * (x_squared + y_squared);
    const float added = above.alpha_x * above.alpha_x + above.alpha_y * above.alpha_y;
    const float total = min(variance + added, 1.0);
    // The ratios are exactly 1 for an isotropic base.
    return lq_facets_prepare(below.ndf, sqrt(total * (x_squared / variance)),
                             sqrt(total * (y_squared / variance)));
}

// The surface with every parameter brought into its range and what does not depend on directions
// computed: call it once per shading point.
LqOpenpbrCoat lq_openpbr_coat_prepare(const LqOneCoat surface) {
    LqOneCoat prepared = lq_one_coat_prepare(surface);
    if (prepared.coat_eta <= 0.0) {
        return LqOpenpbrCoat(prepared, vec3(0.0), 1.0, 1.0);
    }
    float base_roughness = 1.0;
    if (prepared.base == LQ_BASE_CONDUCTOR) {
        const float variance =
            0.5 * (prepared.base_facets.alpha_x * prepared.base_facets.alpha_x +
                   prepared.base_facets.alpha_y * prepared.base_facets.alpha_y);
        base_roughness = sqrt(sqrt(variance));
    }
    prepared.base_facets = lq_openpbr_roughen(prepared.base_facets, prepared.coat);
    prepared.eta = prepared.eta / prepared.coat_eta;
    prepared.kappa = prepared.kappa / prepared.coat_eta;
    return LqOpenpbrCoat(prepared, lq_base_reflectance(prepared, 1.0, 1.0),
                         base_roughness, lq_openpbr_diffuse_escape(prepared.coat_eta));
}

// (1 - E_coat(wo)) Delta: what the coat lets through to wo, times the darkening
// Delta = (1 - K) / (1 - E_b K), K = mix(F(wo), K_r, base roughness).
vec3 lq_openpbr_coat_attenuation(const LqOpenpbrCoat coated, const vec3 wo) {
    const float through = lq_transmittance_dielectric(wo.z, coated.surface.coat_eta);
    const float escape = mix(through, coated.diffuse_escape, coated.base_roughness);
    const vec3 absorbed = (vec3(1.0) - coated.base_albedo) * (1.0 - escape);
    return vec3(through * escape) / max(absorbed + vec3(escape), vec3(LQ_MIN_COSINE_PRODUCT));
}

// Transmittance of the coat's medium along both refracted paths.
vec3 lq_openpbr_coat_absorption(const LqOpenpbrCoat coated, const vec3 wi, const vec3 wo) {
    const float eta = coated.surface.coat_eta;
    const float path = 1.0 / max(lq_refracted_cosine(wi.z, eta), LQ_OPENPBR_MIN_COSINE) +
                       1.0 / max(lq_refracted_cosine(wo.z, eta), LQ_OPENPBR_MIN_COSINE);
    return exp(coated.surface.optical_depth * -path);
}

// The base's part of f. `coated` prepared; wi and wo above the surface.
vec3 lq_openpbr_coat_base(const LqOpenpbrCoat coated, const vec3 wi, const vec3 wo) {
    const vec3 base = lq_base_lobe(coated.surface, wi, wo, 1.0);
    if (coated.surface.coat_eta <= 0.0) {
        return base;
    }
    return base * lq_openpbr_coat_attenuation(coated, wo) * lq_openpbr_coat_absorption(coated, wi, wo);
}

// f(wi, wo), per steradian; 0 unless both directions are above the surface. `coated` prepared.
vec3 lq_openpbr_coat_eval(const LqOpenpbrCoat coated, const vec3 wi, const vec3 wo) {
    if (!lq_is_above(wi)) {
        return vec3(0.0);
    }
    if (!lq_is_above(wo)) {
        return vec3(0.0);
    }
    return lq_openpbr_coat_base(coated, wi, wo) + vec3(lq_coat_lobe(coated.surface, wi, wo));
}

// f(wi, wo) cos_theta_i.
vec3 lq_openpbr_coat_eval_cos(const LqOpenpbrCoat coated, const vec3 wi, const vec3 wo) {
    return lq_openpbr_coat_eval(coated, wi, wo) * max(wi.z, 0.0);
}

// How often `lq_openpbr_coat_sample` chooses the coat for this wo: in proportion to what the coat
// and the base would reflect to wo were they smooth, light coming along the normal.
float lq_openpbr_coat_choice(const LqOpenpbrCoat coated, const vec3 wo) {
    if (coated.surface.coat_eta <= 0.0) {
        return 0.0;
    }
    const vec3 base = coated.base_albedo * lq_openpbr_coat_attenuation(coated, wo) *
                      lq_openpbr_coat_absorption(coated, vec3(0.0, 0.0, 1.0), wo);
    return lq_coat_choice(coated.surface,
                          lq_fresnel_dielectric(wo.z, coated.surface.coat_eta),
                          lq_average(base));
}

// Density per solid angle with which `lq_openpbr_coat_sample` chooses wi; 0 unless both directions
// are above the surface. `coated` prepared.
float lq_openpbr_coat_pdf(const LqOpenpbrCoat coated, const vec3 wi, const vec3 wo) {
    if (!lq_is_above(wi)) {
        return 0.0;
    }
    if (!lq_is_above(wo)) {
        return 0.0;
    }
    return lq_one_coat_pdf(coated.surface, lq_openpbr_coat_choice(coated, wo), wi, wo);
}

// Direction of light for a viewer at wo, from three uniform numbers in [0, 1): the first chooses
// the lobe, the others the direction within it. `coated` prepared.
LqSample lq_openpbr_coat_sample(const LqOpenpbrCoat coated, const vec3 wo, const vec3 u) {
    if (!lq_is_above(wo)) {
        return LqSample(vec3(0.0, 0.0, 1.0), vec3(0.0), 0.0);
    }
    const float coat_choice = lq_openpbr_coat_choice(coated, wo);
    const vec3 wi = lq_one_coat_direction(coated.surface, coat_choice, wo, u);
    const float pdf = lq_openpbr_coat_pdf(coated, wi, wo);
    if (pdf <= 0.0) {
        return LqSample(wi, vec3(0.0), 0.0);
    }
    return LqSample(wi, lq_openpbr_coat_eval_cos(coated, wi, wo) * (1.0 / pdf), pdf);
}

// Fraction of light from every direction that the coat and the base send to wo, by averaging
// `point_count` low-discrepancy samples of each (256 give about three digits). `coated` prepared.
LqAlbedo lq_openpbr_coat_albedo(const LqOpenpbrCoat coated, const vec3 wo, const int point_count) {
    if (!lq_is_above(wo)) {
        return lq_no_albedo();
    }
    const vec3 direct = vec3(lq_coat_albedo(coated.surface, wo, point_count));
    if (coated.surface.coat_eta <= 0.0) {
        return lq_opaque_albedo(direct, lq_base_albedo(coated.surface, wo, point_count));
    }
    const float share = 1.0 / float(max(point_count, 1));
    vec3 base = vec3(0.0);
    for (int index = 0; index < point_count; index++) {
        const vec3 wi =
            lq_base_direction(coated.surface, wo, lq_low_discrepancy_point(uint(index)));
        base += lq_base_weight(coated.surface, wi, wo, 1.0) *
                lq_openpbr_coat_absorption(coated, wi, wo) * share;
    }
    return lq_opaque_albedo(direct, base * lq_openpbr_coat_attenuation(coated, wo));
}

#endif
