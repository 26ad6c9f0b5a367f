// The surface that the simple models shade: an optional dielectric coat over a Lambertian base or a
// conductor.
#ifndef LQ_ONE_COAT_SURFACE_GLSL
#define LQ_ONE_COAT_SURFACE_GLSL

#include "../microfacet/facets.glsl"

// What lies below the coat, or is seen bare.
const int LQ_BASE_NONE = 0;
const int LQ_BASE_LAMBERTIAN = 1;
const int LQ_BASE_CONDUCTOR = 2;

// `coat_eta` is the ior of the coat over that of the exterior, and 0 where there is no coat.
// `optical_depth` is that of the coat's medium along the normal, -log(tau): a logarithm taken on
// the host costs no digits here. `base` is one of LQ_BASE_*; `albedo` is read for a Lambertian
// base, the rest for a conductor, whose `eta + i kappa` is relative to the exterior.
struct LqOneCoat {
    LqFacets coat;
    float coat_eta;
    vec3 optical_depth;
    int base;
    vec3 albedo;
    LqFacets base_facets;
    vec3 eta;
    vec3 kappa;
};

// The surface with every parameter brought into its range.
LqOneCoat lq_one_coat_prepare(const LqOneCoat surface) {
    const float coat_eta =
        surface.coat_eta > 0.0 ? clamp(surface.coat_eta, LQ_MIN_ETA, LQ_MAX_ETA) : 0.0;
    return LqOneCoat(
        lq_facets_prepare(surface.coat.ndf, surface.coat.alpha_x, surface.coat.alpha_y),
        coat_eta,
        clamp(surface.optical_depth, vec3(0.0), vec3(LQ_MAX_OPTICAL_DEPTH)),
        surface.base,
        clamp(surface.albedo, vec3(0.0), vec3(1.0)),
        lq_facets_prepare(surface.base_facets.ndf, surface.base_facets.alpha_x,
                          surface.base_facets.alpha_y),
        clamp(surface.eta, vec3(0.0), vec3(LQ_MAX_CONDUCTOR_INDEX)),
        clamp(surface.kappa, vec3(0.0), vec3(LQ_MAX_CONDUCTOR_INDEX)));
}

#endif
