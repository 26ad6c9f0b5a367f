// The layered model of Weidlich and Wilkie: light enters and leaves through the same facet of the
// coat, is refracted there, crosses the coat's medium twice and meets the base once. Reciprocal.
// The solid angle that refraction compresses, and all light reflected back to the base from within,
// are left out, as in the paper. Without a coat it is the base.
// Based on: Weidlich and Wilkie 2007, Arbitrarily Layered Micro-Facet Surfaces
// Differs: the paper leaves open along which normal the coat's thickness is measured. Its facets
// are much wider than the coat is thick, so here it is that of the facet: each way through is
// 1 / cos_theta_t long, cos_theta_t being the cosine between the refracted light and the facet.
#ifndef LQ_WEIDLICH_WILKIE_WEIDLICH_WILKIE_GLSL
#define LQ_WEIDLICH_WILKIE_WEIDLICH_WILKIE_GLSL

#include "../one_coat/lobes.glsl"

// The surface with every parameter brought into its range: call it once per shading point.
LqOneCoat lq_weidlich_wilkie_prepare(const LqOneCoat surface) {
    return lq_one_coat_prepare(surface);
}

// What becomes of light that enters and leaves through a facet at `cos_theta`, when the fraction
// `masking_shadowing` of facets sees both directions: T12 a t, where T21 = T12 because both ways
// make the same angle with the facet, a is the absorption and t = (1 - G) + T21 G the paper's
// correction for light reflected from within, which it takes to leave elsewhere.
vec3 lq_weidlich_wilkie_passage(const LqOneCoat surface, const float cos_theta,
                                const float masking_shadowing) {
    const float transmittance = lq_transmittance_dielectric(cos_theta, surface.coat_eta);
    if (transmittance <= 0.0) {
        return vec3(0.0);
    }
    const float leaving = (1.0 - masking_shadowing) + transmittance * masking_shadowing;
    const float path = 2.0 / lq_refracted_cosine(cos_theta, surface.coat_eta);
    return exp(surface.optical_depth * -path) * (transmittance * leaving);
}

// `w` refracted by the facet `wm`, which it meets at `cos_theta`; kept pointing out of the base.
vec3 lq_weidlich_wilkie_refract(const vec3 w, const vec3 wm, const float cos_theta,
                                const float coat_eta) {
    const float cos_theta_t = lq_refracted_cosine(cos_theta, coat_eta);
    const vec3 refracted = (w - wm * cos_theta) * (1.0 / coat_eta) + wm * cos_theta_t;
    return vec3(refracted.x, refracted.y, max(refracted.z, 0.0));
}

// The base's f between the refracted directions. Their halfway normal is that of wi and wo.
vec3 lq_weidlich_wilkie_base_lobe(const LqOneCoat surface, const vec3 wi, const vec3 wo,
                                  const float cos_theta) {
    const vec3 reflectance = lq_base_reflectance(
        surface, lq_refracted_cosine(cos_theta, surface.coat_eta), surface.coat_eta);
    if (surface.base != LQ_BASE_CONDUCTOR) {
        return reflectance * LQ_INVERSE_PI;
    }
    const vec3 wm = lq_halfway(wi, wo);
    const float cosines = lq_facets_cosines_over_masking_shadowing(
        surface.base_facets, lq_weidlich_wilkie_refract(wi, wm, cos_theta, surface.coat_eta),
        lq_weidlich_wilkie_refract(wo, wm, cos_theta, surface.coat_eta));
    return reflectance * (0.25 * lq_facets_density(surface.base_facets, wm) / cosines);
}

// The base's part of f. `surface` prepared; wi and wo above the surface.
vec3 lq_weidlich_wilkie_base(const LqOneCoat surface, const vec3 wi, const vec3 wo) {
    if (surface.coat_eta <= 0.0) {
        return lq_base_lobe(surface, wi, wo, 1.0);
    }
    const float cos_theta = lq_cos_theta_halfway(wi, wo);
    const float masking_shadowing = lq_facets_masking_shadowing(surface.coat, wi, wo);
    return lq_weidlich_wilkie_passage(surface, cos_theta, masking_shadowing) *
           lq_weidlich_wilkie_base_lobe(surface, wi, wo, cos_theta);
}

// f(wi, wo), per steradian; 0 unless both directions are above the surface. `surface` prepared.
vec3 lq_weidlich_wilkie_eval(const LqOneCoat surface, const vec3 wi, const vec3 wo) {
    if (!lq_is_above(wi)) {
        return vec3(0.0);
    }
    if (!lq_is_above(wo)) {
        return vec3(0.0);
    }
    return lq_weidlich_wilkie_base(surface, wi, wo) + vec3(lq_coat_lobe(surface, wi, wo));
}

// f(wi, wo) cos_theta_i.
vec3 lq_weidlich_wilkie_eval_cos(const LqOneCoat surface, const vec3 wi, const vec3 wo) {
    return lq_weidlich_wilkie_eval(surface, wi, wo) * max(wi.z, 0.0);
}

// How often `lq_weidlich_wilkie_sample` chooses the coat for this wo: in proportion to what the
// coat and the base would reflect straight back were they smooth.
float lq_weidlich_wilkie_coat_choice(const LqOneCoat surface, const vec3 wo) {
    if (surface.coat_eta <= 0.0) {
        return 0.0;
    }
    const vec3 base =
        lq_base_reflectance(surface, lq_refracted_cosine(wo.z, surface.coat_eta),
                            surface.coat_eta) *
        lq_weidlich_wilkie_passage(surface, wo.z, 1.0);
    return lq_coat_choice(surface, lq_fresnel_dielectric(wo.z, surface.coat_eta),
                          lq_average(base));
}

// Density per solid angle with which `lq_weidlich_wilkie_sample` chooses wi; 0 unless both
// directions are above the surface. `surface` prepared.
float lq_weidlich_wilkie_pdf(const LqOneCoat surface, const vec3 wi, const vec3 wo) {
    if (!lq_is_above(wi)) {
        return 0.0;
    }
    if (!lq_is_above(wo)) {
        return 0.0;
    }
    return lq_one_coat_pdf(surface, lq_weidlich_wilkie_coat_choice(surface, wo), wi, wo);
}

// Direction of light for a viewer at wo, from three uniform numbers in [0, 1): the first chooses
// the lobe, the others the direction within it. `surface` prepared.
LqSample lq_weidlich_wilkie_sample(const LqOneCoat surface, const vec3 wo, const vec3 u) {
    if (!lq_is_above(wo)) {
        return LqSample(vec3(0.0, 0.0, 1.0), vec3(0.0), 0.0);
    }
    const float coat_choice = lq_weidlich_wilkie_coat_choice(surface, wo);
    const vec3 wi = lq_one_coat_direction(surface, coat_choice, wo, u);
    const float pdf = lq_weidlich_wilkie_pdf(surface, wi, wo);
    if (pdf <= 0.0) {
        return LqSample(wi, vec3(0.0), 0.0);
    }
    return LqSample(wi, lq_weidlich_wilkie_eval_cos(surface, wi, wo) * (1.0 / pdf), pdf);
}

// Fraction of light from every direction that the coat and the base send to wo, by averaging
// `point_count` low-discrepancy samples of each (256 give about three digits). `surface` prepared.
LqAlbedo lq_weidlich_wilkie_albedo(const LqOneCoat surface, const vec3 wo, const int point_count) {
    if (!lq_is_above(wo)) {
        return lq_no_albedo();
    }
    const float share = 1.0 / float(max(point_count, 1));
    vec3 base = vec3(0.0);
    for (int index = 0; index < point_count; index++) {
        const vec3 wi = lq_base_direction(surface, wo, lq_low_discrepancy_point(uint(index)));
        if (lq_is_above(wi)) {
            const float pdf = lq_base_pdf(surface, wi, wo);
            if (pdf > 0.0) {
                base += lq_weidlich_wilkie_base(surface, wi, wo) * (share * wi.z / pdf);
            }
        }
    }
    return lq_opaque_albedo(vec3(lq_coat_albedo(surface, wo, point_count)), base);
}

#endif
