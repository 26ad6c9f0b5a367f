// The surface that `lq_plain_*` shades: an optional dielectric coat over a base, as most engines
// have it today.
#ifndef LQ_PLAIN_SURFACE_GLSL
#define LQ_PLAIN_SURFACE_GLSL

#include "../microfacet/facets.glsl"

// What lies below the coat, or is seen bare.
const int LQ_BASE_NONE = 0;
const int LQ_BASE_LAMBERTIAN = 1;
const int LQ_BASE_CONDUCTOR = 2;

// `coat_eta` is the ior of the coat over that of the exterior, and 0 where there is no coat.
// `base` is one of LQ_BASE_*; `albedo` is read for a Lambertian base, the rest for a conductor,
// whose `eta + i kappa` is relative to the exterior.
struct LqPlainSurface {
    LqFacets coat;
    float coat_eta;
    int base;
    vec3 albedo;
    LqFacets base_facets;
    vec3 eta;
    vec3 kappa;
};

// The surface with every parameter brought into its range: call it once per shading point.
LqPlainSurface lq_plain_prepare(const LqPlainSurface surface) {
    const float coat_eta =
        surface.coat_eta > 0.0 ? clamp(surface.coat_eta, LQ_MIN_ETA, LQ_MAX_ETA) : 0.0;
    return LqPlainSurface(
        lq_facets_prepare(surface.coat.ndf, surface.coat.alpha_x, surface.coat.alpha_y),
        coat_eta,
        surface.base,
        clamp(surface.albedo, vec3(0.0), vec3(1.0)),
        lq_facets_prepare(surface.base_facets.ndf, surface.base_facets.alpha_x,
                          surface.base_facets.alpha_y),
        clamp(surface.eta, vec3(0.0), vec3(LQ_MAX_CONDUCTOR_INDEX)),
        clamp(surface.kappa, vec3(0.0), vec3(LQ_MAX_CONDUCTOR_INDEX)));
}

#endif
