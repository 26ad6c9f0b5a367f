// Light reflected once by a facet: the Cook-Torrance lobe without its Fresnel factor.
// Based on: Walter et al. 2007, Microfacet Models for Refraction through Rough Surfaces
#ifndef LQ_MICROFACET_REFLECTION_GLSL
#define LQ_MICROFACET_REFLECTION_GLSL

#include "facets.glsl"

// The facet normal that mirrors wo into wi, for both above the surface. Directions opposite along
// the horizon have none: the macroscopic normal stands in.
vec3 lq_halfway(const vec3 wi, const vec3 wo) {
    const vec3 sum = wi + wo;
    const float length_squared = dot(sum, sum);
    if (length_squared < LQ_MIN_COSINE_PRODUCT) {
        return vec3(0.0, 0.0, 1.0);
    }
    return sum * (1.0 / sqrt(length_squared));
}

// Cosine of the angle between either direction and their halfway normal. Half the length of the
// sum: for nearly opposite directions at grazing it keeps the digits that their dot product loses.
float lq_cos_theta_halfway(const vec3 wi, const vec3 wo) {
    return min(0.5 * length(wi + wo), 1.0);
}

// D G2 / (4 cos_theta_i cos_theta_o), per solid angle, for wi and wo above the surface. Walter et
// al. 2007, Eq. 20 without F.
float lq_reflection_lobe(const LqFacets facets, const vec3 wi, const vec3 wo) {
    const float density = lq_facets_density(facets, lq_halfway(wi, wo));
    return 0.25 * density / lq_facets_cosines_over_masking_shadowing(facets, wi, wo);
}

// Density per solid angle of wi when the normals visible from wo mirror it:
// D_wo(wm) / (4 dot(wo, wm)) = D(wm) / (4 (cos_theta_o + cos_theta_o Lambda(wo))).
float lq_reflection_pdf(const LqFacets facets, const vec3 wi, const vec3 wo) {
    const float density = lq_facets_density(facets, lq_halfway(wi, wo));
    const float lambda_o = lq_facets_projected_lambda(facets, wo);
    return 0.25 * density / max(wo.z + lambda_o, LQ_MIN_COSINE_PRODUCT);
}

// wo mirrored by a normal visible from it. May point below the surface: such light meets another
// facet, which a lobe of single reflections leaves out.
vec3 lq_reflection_sample(const LqFacets facets, const vec3 wo, const vec2 u) {
    const vec3 wm = lq_facets_sample_visible_normal(facets, wo, u);
    return wm * (2.0 * dot(wo, wm)) - wo;
}

#endif
