// The light that the coat reflects without letting it in: once by its facets, and diffusely what
// meets more than one, so that none is lost.
// Based on: Walter et al. 2007, Microfacet Models for Refraction through Rough Surfaces;
//           Kulla and Conty 2017, Revisiting Physically Based Shading at Imageworks (the diffuse part)
//
//   f = F D G2 / (4 cos_theta_i cos_theta_o) + m(wi) m(wo) / (pi m_average)
//
// with m(w) the part of the directional albedo that has met more than one facet.
#ifndef LQ_COATED_COAT_LOBE_GLSL
#define LQ_COATED_COAT_LOBE_GLSL

#include "../core/sampling.glsl"
#include "../core/shading.glsl"
#include "../fresnel/dielectric.glsl"
#include "../microfacet/reflection.glsl"
#include "surface.glsl"

float lq_coated_multiple(const LqCoatedSurface surface, const vec3 w) {
    return lq_interface_fgd_multiple(surface.energies, min(w.z, 1.0));
}

// Directional albedo of all orders of scattering.
float lq_coated_coat_albedo(const LqCoatedSurface surface, const vec3 w) {
    return 1.0 - lq_interface_t_down(surface.energies, min(w.z, 1.0)).w;
}

// The coat's part of f, for wi and wo above the surface.
float lq_coated_coat(const LqCoatedSurface surface, const vec3 wi, const vec3 wo) {
    const float once = lq_fresnel_dielectric(lq_cos_theta_halfway(wi, wo), surface.eta) *
                       lq_reflection_lobe(surface.coat, wi, wo);
    const float again = lq_coated_multiple(surface, wi) * lq_coated_multiple(surface, wo) *
                        (LQ_INVERSE_PI / surface.energies.multiple_average);
    return once + again;
}

// How often `lq_coated_coat_sample` mirrors wo by a facet, rather than choosing any direction.
float lq_coated_once_choice(const LqCoatedSurface surface, const vec3 wo) {
    const float albedo = lq_coated_coat_albedo(surface, wo);
    if (albedo <= 0.0) {
        return 1.0;
    }
    return max(1.0 - lq_coated_multiple(surface, wo) / albedo, LQ_MIN_CHOICE);
}

float lq_coated_coat_pdf(const LqCoatedSurface surface, const vec3 wi, const vec3 wo) {
    const float once = lq_coated_once_choice(surface, wo);
    return once * lq_reflection_pdf(surface.coat, wi, wo) +
           (1.0 - once) * lq_cosine_hemisphere_pdf(wi.z);
}

// May point below the surface. `choice` in [0, 1).
vec3 lq_coated_coat_sample(const LqCoatedSurface surface, const vec3 wo, const float choice,
                           const vec2 u) {
    if (choice < lq_coated_once_choice(surface, wo)) {
        return lq_reflection_sample(surface.coat, wo, u);
    }
    return lq_sample_cosine_hemisphere(u);
}

#endif
