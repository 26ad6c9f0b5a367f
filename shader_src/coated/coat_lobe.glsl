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

// The coat's part of f, for wi and the viewer above the surface.
float lq_coated_coat(const LqCoatedSurface surface, const LqCoatedView viewer, const vec3 wi) {
    const float once = lq_fresnel_dielectric(lq_cos_theta_halfway(wi, viewer.wo), surface.eta) *
                       lq_reflection_lobe(surface.coat, wi, viewer.wo);
    const float multiple = lq_interface_fgd_multiple(surface.energies, min(wi.z, 1.0));
    return once + multiple * viewer.multiple * surface.multiple_scale;
}

// How often `lq_coated_coat_sample` mirrors wo by a facet, rather than choosing any direction.
float lq_coated_once_choice(const LqCoatedView viewer) {
    if (viewer.coat <= 0.0) {
        return 1.0;
    }
    return max(1.0 - viewer.multiple / viewer.coat, LQ_MIN_CHOICE);
}

// Density of `lq_coated_coat_sample`.
float lq_coated_coat_pdf(const LqCoatedSurface surface, const LqCoatedView viewer, const vec3 wi) {
    const float once = lq_coated_once_choice(viewer);
    return once * lq_reflection_pdf(surface.coat, wi, viewer.wo) +
           (1.0 - once) * lq_cosine_hemisphere_pdf(wi.z);
}

// May point below the surface. `choice` in [0, 1).
vec3 lq_coated_coat_sample(const LqCoatedSurface surface, const LqCoatedView viewer,
                           const float choice, const vec2 u) {
    if (choice < lq_coated_once_choice(viewer)) {
        return lq_reflection_sample(surface.coat, viewer.wo, u);
    }
    return lq_sample_cosine_hemisphere(u);
}

#endif
