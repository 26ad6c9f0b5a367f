// What the models of one coat share: the coat's single reflections, the base's lobe, and choosing a
// direction from either. Surfaces are prepared; wi and wo are above the surface.
// Based on: Walter et al. 2007, Microfacet Models for Refraction through Rough Surfaces
#ifndef LQ_ONE_COAT_LOBES_GLSL
#define LQ_ONE_COAT_LOBES_GLSL

#include "../core/frame.glsl"
#include "../core/sampling.glsl"
#include "../core/shading.glsl"
#include "../fresnel/conductor.glsl"
#include "../fresnel/dielectric.glsl"
#include "../microfacet/reflection.glsl"
#include "surface.glsl"

// The coat's single reflections, part of f.
float lq_coat_lobe(const LqOneCoat surface, const vec3 wi, const vec3 wo) {
    if (surface.coat_eta <= 0.0) {
        return 0.0;
    }
    return lq_fresnel_dielectric(lq_cos_theta_halfway(wi, wo), surface.coat_eta) *
           lq_reflection_lobe(surface.coat, wi, wo);
}

// What the base would reflect at this angle were it smooth, in a medium of ior `eta_above` over the
// exterior's: its albedo, or its Fresnel reflectance.
vec3 lq_base_reflectance(const LqOneCoat surface, const float cos_theta, const float eta_above) {
    if (surface.base == LQ_BASE_LAMBERTIAN) {
        return surface.albedo;
    }
    if (surface.base == LQ_BASE_CONDUCTOR) {
        const float scale = 1.0 / eta_above;
        return lq_fresnel_conductor_rgb(cos_theta, surface.eta * scale, surface.kappa * scale);
    }
    return vec3(0.0);
}

// The base's f, as if no coat lay over it, in a medium of ior `eta_above` over the exterior's.
vec3 lq_base_lobe(const LqOneCoat surface, const vec3 wi, const vec3 wo, const float eta_above) {
    const vec3 reflectance =
        lq_base_reflectance(surface, lq_cos_theta_halfway(wi, wo), eta_above);
    if (surface.base == LQ_BASE_CONDUCTOR) {
        return reflectance * lq_reflection_lobe(surface.base_facets, wi, wo);
    }
    return reflectance * LQ_INVERSE_PI;
}

// Density of `lq_base_direction`.
float lq_base_pdf(const LqOneCoat surface, const vec3 wi, const vec3 wo) {
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
vec3 lq_base_direction(const LqOneCoat surface, const vec3 wo, const vec2 u) {
    if (surface.base == LQ_BASE_CONDUCTOR) {
        return lq_reflection_sample(surface.base_facets, wo, u);
    }
    return lq_sample_cosine_hemisphere(u);
}

// How often a direction is chosen from the coat where it reflects the fraction `coat` and the base
// the fraction `base`.
float lq_coat_choice(const LqOneCoat surface, const float coat, const float base) {
    if (surface.coat_eta <= 0.0) {
        return 0.0;
    }
    if (surface.base == LQ_BASE_NONE) {
        return 1.0;
    }
    return clamp(coat / (coat + base + LQ_MIN_COSINE_PRODUCT), LQ_MIN_CHOICE,
                 1.0 - LQ_MIN_CHOICE);
}

// Density per solid angle of `lq_one_coat_direction`.
float lq_one_coat_pdf(const LqOneCoat surface, const float coat_choice, const vec3 wi,
                      const vec3 wo) {
    float pdf = 0.0;
    if (coat_choice > 0.0) {
        pdf = coat_choice * lq_reflection_pdf(surface.coat, wi, wo);
    }
    return pdf + (1.0 - coat_choice) * lq_base_pdf(surface, wi, wo);
}

// Direction of light for a viewer at wo, from three uniform numbers in [0, 1): the first chooses
// the coat with probability `coat_choice`, or the base; the others the direction within its lobe.
// May point below the surface.
vec3 lq_one_coat_direction(const LqOneCoat surface, const float coat_choice, const vec3 wo,
                           const vec3 u) {
    const vec2 square = vec2(u.y, u.z);
    if (u.x < coat_choice) {
        return lq_reflection_sample(surface.coat, wo, square);
    }
    return lq_base_direction(surface, wo, square);
}

// The fraction of facets seen from wo whose mirrored light no other facet hides, for a direction of
// `lq_reflection_sample`: its lobe without F, times cos_theta_i, over its density.
float lq_shown_fraction(const LqFacets facets, const vec3 wi, const vec3 wo) {
    if (!lq_is_above(wi)) {
        return 0.0;
    }
    return lq_facets_masking_shadowing(facets, wi, wo) / lq_facets_masking(facets, wo);
}

// Directional albedo of `lq_coat_lobe`, by averaging `point_count` low-discrepancy samples.
float lq_coat_albedo(const LqOneCoat surface, const vec3 wo, const int point_count) {
    if (surface.coat_eta <= 0.0) {
        return 0.0;
    }
    const float share = 1.0 / float(max(point_count, 1));
    float albedo = 0.0;
    for (int index = 0; index < point_count; index++) {
        const vec2 square = lq_low_discrepancy_point(uint(index));
        const vec3 wi = lq_reflection_sample(surface.coat, wo, square);
        albedo += share * lq_shown_fraction(surface.coat, wi, wo) *
                  lq_fresnel_dielectric(lq_cos_theta_halfway(wi, wo), surface.coat_eta);
    }
    return albedo;
}

// `lq_base_lobe` times cos_theta_i over `lq_base_pdf`, for a direction of `lq_base_direction`.
vec3 lq_base_weight(const LqOneCoat surface, const vec3 wi, const vec3 wo, const float eta_above) {
    const vec3 reflectance =
        lq_base_reflectance(surface, lq_cos_theta_halfway(wi, wo), eta_above);
    if (surface.base == LQ_BASE_CONDUCTOR) {
        return reflectance * lq_shown_fraction(surface.base_facets, wi, wo);
    }
    return reflectance;
}

// Directional albedo of `lq_base_lobe` below the exterior, a conductor's by averaging `point_count`
// low-discrepancy samples.
vec3 lq_base_albedo(const LqOneCoat surface, const vec3 wo, const int point_count) {
    if (surface.base != LQ_BASE_CONDUCTOR) {
        return lq_base_reflectance(surface, wo.z, 1.0);
    }
    const float share = 1.0 / float(max(point_count, 1));
    vec3 albedo = vec3(0.0);
    for (int index = 0; index < point_count; index++) {
        const vec3 wi = lq_base_direction(surface, wo, lq_low_discrepancy_point(uint(index)));
        albedo += lq_base_weight(surface, wi, wo, 1.0) * share;
    }
    return albedo;
}

#endif
