// Isotropic GGX roughnesses that stand for other facets.
#ifndef LQ_MICROFACET_EQUIVALENT_ALPHA_GLSL
#define LQ_MICROFACET_EQUIVALENT_ALPHA_GLSL

#include "facets.glsl"

float lq_mean_alpha(const LqFacets facets) {
    return clamp(0.5 * (facets.alpha_x + facets.alpha_y), 0.0, 1.0);
}

// Whose energies are those of an interface of index `eta`, to some percent: the mean of two
// roughnesses; and less of Beckmann's, which has fewer steep facets.
float lq_equivalent_energy_alpha(const LqFacets facets, const float eta) {
    const float alpha = lq_mean_alpha(facets);
    if (facets.ndf == LQ_NDF_BECKMANN) {
        return alpha * (0.52 + (eta < 1.0 ? 0.41 : 0.09) * alpha);
    }
    return alpha;
}

// Whose lobes are as wide.
float lq_equivalent_lobe_alpha(const LqFacets facets) {
    const float alpha = lq_mean_alpha(facets);
    return facets.ndf == LQ_NDF_BECKMANN ? alpha * (0.425 + 0.15 * alpha) : alpha;
}

#endif
