// The layers of a stack as shaders read them, clamped to what tables and formulas hold.
#ifndef LQ_STACK_LAYERS_GLSL
#define LQ_STACK_LAYERS_GLSL

#include "../core/math.glsl"
#include "../microfacet/equivalent_alpha.glsl"
#include "../microsurface/strata.glsl"
#include "material.glsl"

const float LQ_MOST_DEPTH = 80.0;  // lets no light through
const float LQ_MOST_G = 0.99;
const float LQ_LEAST_INDEX = 0.01;
const float LQ_MOST_INDEX = 100.0;

// An interface: the index below it over that above, and its strata: `count` rows from `row` on; a
// uniform one has one, whose weight is not read. `blend` is one of LQ_BLEND_*.
struct LqStackInterface {
    float eta;
    int blend;
    int count;
    int row;
};

// Facets of one stratum: the roughness of its energies, that of the GGX lobe as wide as its own, and
// its part of the area.
struct LqStackStratum {
    float alpha;
    float lobe_alpha;
    float weight;
};

// A medium: optical depths along the normal, and the mean cosine of its phase function.
struct LqStackMedium {
    vec3 absorption;
    vec3 scattering;
    float g;
};

// The index of the medium below layer n, and of the exterior at -1.
float lq_stack_index(const int first_row, const int n) {
    if (n < 0) {
        return 1.0;
    }
    return clamp(lq_stack_row(first_row + LQ_LAYER_ROWS * n).z, LQ_LEAST_INDEX, LQ_MOST_INDEX);
}

LqStackInterface lq_stack_interface(const int first_row, const int n) {
    const vec4 row = lq_stack_row(first_row + LQ_LAYER_ROWS * n);
    const float index = clamp(row.z, LQ_LEAST_INDEX, LQ_MOST_INDEX);
    const float eta = clamp(index / lq_stack_index(first_row, n - 1), LQ_MIN_ETA, LQ_MAX_ETA);
    if (int(row.w) == LQ_STACK_BLENDED) {
        const vec4 last = lq_stack_row(first_row + LQ_LAYER_ROWS * n + 2);
        return LqStackInterface(eta, int(row.y), clamp(int(row.x), 1, LQ_MAX_STRATA),
                                first_row + int(last.w));
    }
    return LqStackInterface(eta, LQ_BLEND_ASYMMETRIC, 1, first_row + LQ_LAYER_ROWS * n);
}

// The n-th from the top.
LqStackStratum lq_stack_stratum(const LqStackInterface at, const int n) {
    const vec4 row = lq_stack_row(at.row + n);
    const LqFacets facets = LqFacets(int(row.w), row.x, row.y);
    return LqStackStratum(lq_equivalent_energy_alpha(facets, at.eta),
                          lq_equivalent_lobe_alpha(facets), row.z);
}

vec3 lq_stack_depths(const vec4 row) {
    return vec3(clamp(row.x, 0.0, LQ_MOST_DEPTH), clamp(row.y, 0.0, LQ_MOST_DEPTH),
                clamp(row.z, 0.0, LQ_MOST_DEPTH));
}

// Of the medium below layer n.
LqStackMedium lq_stack_medium(const int first_row, const int n) {
    const int row = first_row + LQ_LAYER_ROWS * n;
    const vec4 absorption = lq_stack_row(row + 1);
    return LqStackMedium(lq_stack_depths(absorption), lq_stack_depths(lq_stack_row(row + 2)),
                         clamp(absorption.w, -LQ_MOST_G, LQ_MOST_G));
}

bool lq_scatters(const LqStackMedium medium) {
    return max(max(medium.scattering.x, medium.scattering.y), medium.scattering.z) > 0.0;
}

#endif
