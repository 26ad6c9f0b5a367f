// What `lq_stack_*` shades: rough dielectric interfaces from the top, a medium below each, and a base.
//
// Whoever includes this supplies `vec4 lq_stack_row(const int index)`: the rows of parameters of all
// layers, from a buffer or an array. Shaders take them when light meets a layer: arrays handed from
// function to function would be copied each time.
#ifndef LQ_STACK_MATERIAL_GLSL
#define LQ_STACK_MATERIAL_GLSL

#include "../microfacet/facets.glsl"

// Choices made before including this. LQ_MAX_LAYERS: the most layers of a stack; fewer make shaders
// smaller. LQ_STACK_LOBES: the lobes that interfaces and a conductor have above the surface. 3: of
// the top interface, of those below it, and of the conductor; 2, for speed: the latter two are one.
#ifndef LQ_MAX_LAYERS
#define LQ_MAX_LAYERS 8
#endif
#ifndef LQ_STACK_LOBES
#define LQ_STACK_LOBES 3
#endif
#if LQ_MAX_LAYERS < 1
#error "LQ_MAX_LAYERS is at least 1"
#endif
#if LQ_STACK_LOBES < 2 || LQ_STACK_LOBES > 3
#error "LQ_STACK_LOBES is 2 or 3"
#endif

// What light meets on its way: interfaces, and media that scatter.
#define LQ_MAX_LEVELS (LQ_MAX_LAYERS * 2)

const int LQ_STACK_BASE_NONE = 0;
const int LQ_STACK_BASE_LAMBERTIAN = 1;
const int LQ_STACK_BASE_CONDUCTOR = 2;

// Rows of a layer.
const int LQ_LAYER_ROWS = 3;

// In place of the ndf, of an interface of several strata.
const int LQ_STACK_BLENDED = -1;

// Layers in [1, LQ_MAX_LAYERS], from the top, have LQ_LAYER_ROWS rows each from `first_row` on:
// (alpha_x, alpha_y, index over the exterior's, ndf) of the interface, the index that of the medium
// below it in [1/3, 3] and neighbouring ones in that proportion to each other, ndf one of LQ_NDF_*;
// (optical depths sigma_a d of that medium along the normal, at least 0, per channel; mean cosine g
// of its phase function in [-1, 1]); (optical depths sigma_s d; 0).
// Of an interface that is a blend the first row is (stratum count in [1, LQ_MAX_STRATA], one of
// LQ_BLEND_*, index, LQ_STACK_BLENDED), and the last component of the third says how many rows after
// `first_row` its strata begin, from the top down, each (alpha_x, alpha_y, weight, ndf): weights of the
// area add up to 1, and the lowest takes the rest.
// `base` is one of LQ_STACK_BASE_*. Lambertian: `albedo` in [0, 1]. Conductor: `facets`, and its
// index eta + i kappa over the exterior's.
struct LqStackMaterial {
    int first_row;
    int layer_count;
    int base;
    vec3 albedo;
    LqFacets facets;
    vec3 eta;
    vec3 kappa;
};

#endif
