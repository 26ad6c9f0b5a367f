// What `lq_stack_*` shades: rough dielectric interfaces from the top, a medium below each, and a base.
#ifndef LQ_STACK_MATERIAL_GLSL
#define LQ_STACK_MATERIAL_GLSL

#include "../microfacet/facets.glsl"

// The most layers of a stack. Fewer make shaders smaller: define it before including this.
#ifndef LQ_MAX_LAYERS
#define LQ_MAX_LAYERS 8
#endif

// What light meets on its way: interfaces, and media that scatter.
#define LQ_MAX_LEVELS (LQ_MAX_LAYERS * 2)

const int LQ_STACK_BASE_NONE = 0;
const int LQ_STACK_BASE_LAMBERTIAN = 1;
const int LQ_STACK_BASE_CONDUCTOR = 2;

// `layer_count` in [1, LQ_MAX_LAYERS]. Of layer n, counted from the top: interfaces[n] is (alpha_x,
// alpha_y, index over the exterior's, ndf) with the index of the medium below it in [1/3, 3] and
// neighbouring ones in that proportion to each other, ndf one of LQ_NDF_*; absorption[n] is
// (optical depth sigma_a d of that medium along the normal, at least 0, per channel; mean cosine g of
// its phase function in [-1, 1]) and scattering[n] (optical depth sigma_s d, 0).
// `base` is one of LQ_STACK_BASE_*. Lambertian: `albedo` in [0, 1]. Conductor: `facets`, and its
// index eta + i kappa over the exterior's.
struct LqStackMaterial {
    int layer_count;
    vec4 interfaces[LQ_MAX_LAYERS];
    vec4 absorption[LQ_MAX_LAYERS];
    vec4 scattering[LQ_MAX_LAYERS];
    int base;
    vec3 albedo;
    LqFacets facets;
    vec3 eta;
    vec3 kappa;
};

#endif
