// A stack as prepared for shading, for any number of viewers and lights.
#ifndef LQ_STACK_SURFACE_GLSL
#define LQ_STACK_SURFACE_GLSL

#include "../interface/polynomial.glsl"
#include "conductor.glsl"
#include "interface.glsl"
#include "layers.glsl"

// `level_count` counts what light meets above the base: interfaces, and media that scatter.
// `exit_place` is where light leaves that goes through (lq_meet), -1 where none does. `index` is that
// of the medium above the base. `base_alpha`, `base_lobe_alpha`, `base_eta` and `base_kappa` are a
// conductor's, relative to that medium, and `base_conductor` what it reflects; `base_albedo` is a
// Lambertian base's.
// `top` and `top_eta` are the top interface's lobe where it is uniform, `top_count` being 1; `top_critical`, `top_above` and `top_below` what
// it lets in (lq_stack_entering); `multiple` the part of its albedo that has met more than one facet,
// `multiple_scale` what makes its product of two directions an f.
struct LqStackSurface {
    int first_row;
    int layer_count;
    int level_count;
    int base;
    int exit_place;
    float index;
    vec3 base_albedo;
    float base_alpha;
    float base_lobe_alpha;
    vec3 base_eta;
    vec3 base_kappa;
    LqConductorAlbedo base_conductor;
    LqFacets top;
    int top_count;
    float top_alpha;
    float top_eta;
    float top_critical;
    LqOctet top_above;
    LqOctet top_below;
    LqDirectionPolynomial multiple;
    float multiple_scale;
};

// As far from the cosine of the top interface's critical angle as its facets tilt: more obliquely
// hardly any light enters a thinner medium.
float lq_least_entering_cosine(const LqStackSurface surface) {
    return max(surface.top_critical - surface.top_alpha, 0.0);
}

#endif
