// A rough interface: a distribution of facet normals and its two roughnesses, with the operations
// that every lobe is made of. Smith masking, height-correlated.
// Based on: Heitz 2014, Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs
#ifndef LQ_MICROFACET_FACETS_GLSL
#define LQ_MICROFACET_FACETS_GLSL

#include "beckmann.glsl"
#include "ggx.glsl"

// Names of the distributions of facet normals.
const int LQ_NDF_GGX = 0;
const int LQ_NDF_BECKMANN = 1;

// `ndf` is one of LQ_NDF_*; the alphas are slope roughnesses along x and y, in [LQ_MIN_ALPHA, 1].
struct LqFacets {
    int ndf;
    float alpha_x;
    float alpha_y;
};

// Facets with every parameter brought into its range.
LqFacets lq_facets_prepare(const int ndf, const float alpha_x, const float alpha_y) {
    return LqFacets(ndf, clamp(alpha_x, LQ_MIN_ALPHA, 1.0), clamp(alpha_y, LQ_MIN_ALPHA, 1.0));
}

// D(wm), per solid angle; wm unit.
float lq_facets_density(const LqFacets facets, const vec3 wm) {
    if (facets.ndf == LQ_NDF_BECKMANN) {
        return lq_beckmann_density(wm, facets.alpha_x, facets.alpha_y);
    }
    return lq_ggx_density(wm, facets.alpha_x, facets.alpha_y);
}

// cos_theta Lambda(w): finite at grazing, where Lambda alone is not.
float lq_facets_projected_lambda(const LqFacets facets, const vec3 w) {
    if (facets.ndf == LQ_NDF_BECKMANN) {
        return lq_beckmann_projected_lambda(w, facets.alpha_x, facets.alpha_y);
    }
    return lq_ggx_projected_lambda(w, facets.alpha_x, facets.alpha_y);
}

// G1(w) = 1 / (1 + Lambda(w)): the fraction of facets not hidden from w.
float lq_facets_masking(const LqFacets facets, const vec3 w) {
    return w.z / max(w.z + lq_facets_projected_lambda(facets, w), LQ_MIN_COSINE_PRODUCT);
}

// cos_theta_i cos_theta_o / G2(wi, wo), G2 = 1 / (1 + Lambda(wi) + Lambda(wo)): positive terms only.
float lq_facets_cosines_over_masking_shadowing(const LqFacets facets, const vec3 wi,
                                               const vec3 wo) {
    const float lambda_i = lq_facets_projected_lambda(facets, wi);
    const float lambda_o = lq_facets_projected_lambda(facets, wo);
    return max(wi.z * wo.z + wo.z * lambda_i + wi.z * lambda_o, LQ_MIN_COSINE_PRODUCT);
}

// G2(wi, wo), the fraction of facets hidden from neither direction. Heitz 2014, Eq. 99.
float lq_facets_masking_shadowing(const LqFacets facets, const vec3 wi, const vec3 wo) {
    return wi.z * wo.z / lq_facets_cosines_over_masking_shadowing(facets, wi, wo);
}

// Facet normal with the density of those visible from w, for u in [0, 1)^2.
vec3 lq_facets_sample_visible_normal(const LqFacets facets, const vec3 w, const vec2 u) {
    if (facets.ndf == LQ_NDF_BECKMANN) {
        return lq_beckmann_sample_visible_normal(w, facets.alpha_x, facets.alpha_y, u);
    }
    return lq_ggx_sample_visible_normal(w, facets.alpha_x, facets.alpha_y, u);
}

#endif
