// A stack as prepared for shading: once per material, for any number of viewers and lights.
#ifndef LQ_STACK_SURFACE_GLSL
#define LQ_STACK_SURFACE_GLSL

#include "../interface/polynomial.glsl"
#include "conductor.glsl"
#include "interface.glsl"
#include "material.glsl"

// Coefficients of powers of cos_theta, a colour channel in each component.
struct LqCubic {
    vec4 zeroth;
    vec4 first;
    vec4 second;
    vec4 third;
};

// interfaces[n] is (roughness of its energies, index above it, index below it, larger index over
// the smaller); `rows` holds LQ_INTERFACE_ROWS for each. absorption[n] and scattering[n]
// are optical depths of the medium below it, the fourth component of the latter g.
// levels[n] is what light meets: (layer, 0 for its interface or 1 for its medium, which scatters, and
// the layers whose media only absorb above and below, or -1).
// `base_alpha`, `base_eta` and `base_kappa` are a conductor's, relative to the medium above it, and
// `base_albedo` what it reflects.
// `top` and `top_eta` are the top interface's lobe, `top_critical`, `top_above` and `top_below` what
// it lets in (lq_entering); `multiple` the part of its albedo that has met
// more than one facet, `multiple_scale` 1 / (pi times its average).
// Over a Lambertian base `arriving` is, of what the top interface lets in, the share
// that arrives at the base; `spread` is rho / (pi n^2 (1 - rho R_bar)),
// `returned` what of the light that has arrived leaves the stack.
struct LqStackSurface {
    int layer_count;
    int level_count;
    int base;
    vec4 levels[LQ_MAX_LEVELS];
    vec4 interfaces[LQ_MAX_LAYERS];
    vec4 rows[LQ_MAX_LAYERS * LQ_INTERFACE_ROWS];
    vec4 absorption[LQ_MAX_LAYERS];
    vec4 scattering[LQ_MAX_LAYERS];
    float base_alpha;
    vec3 base_eta;
    vec3 base_kappa;
    LqConductorAlbedo base_albedo;
    LqFacets top;
    float top_eta;
    float top_critical;
    LqOctet top_above;
    LqOctet top_below;
    LqDirectionPolynomial multiple;
    float multiple_scale;
    LqCubic arriving;
    vec3 spread;
    vec3 returned;
};

#endif
