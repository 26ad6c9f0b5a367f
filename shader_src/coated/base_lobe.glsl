// The light that comes back through the coat from the base below it.
// Based on: de Dinechin and Belcour 2022, Rendering Layered Materials with Diffuse Interfaces,
//           Eq. 3 (its energy), Eq. 5 (the GGX lobe)
#ifndef LQ_COATED_BASE_LOBE_GLSL
#define LQ_COATED_BASE_LOBE_GLSL

#include "../core/sampling.glsl"
#include "../microfacet/reflection.glsl"
#include "surface.glsl"

// The base's part of f, for wi and the viewer above the surface.
// Exact: T01(wi) T01(wo) rho / (pi eta^2 (1 - rho R10_bar)): a Lambertian base forgets directions,
// and light takes the same paths both ways.
vec3 lq_coated_base(const LqCoatedSurface surface, const LqCoatedView viewer, const vec3 wi) {
    if (surface.base_lobe == LQ_BASE_LOBE_GGX) {
        const float lobe = lq_reflection_lobe(surface.lobe, wi, vec3(0.0, 0.0, 1.0));
        return viewer.base * (lobe / surface.lobe_energy);
    }
    const vec4 entering = lq_interface_t_down(surface.energies, min(wi.z, 1.0));
    return vec3(entering.x, entering.y, entering.z) * (viewer.entering * surface.spread);
}

// Of the facets as seen along the normal, those that mirror it above the surface.
float lq_coated_lobe_share(const LqCoatedSurface surface) {
    return 1.0 / (1.0 + lq_square(surface.lobe.alpha_x));
}

// Density of `lq_coated_base_sample`, which does not depend on the viewer; wi above the surface.
float lq_coated_base_pdf(const LqCoatedSurface surface, const vec3 wi) {
    if (surface.base_lobe == LQ_BASE_LOBE_EXACT) {
        return lq_cosine_hemisphere_pdf(wi.z);
    }
    const vec3 wm = lq_halfway(wi, vec3(0.0, 0.0, 1.0));
    return 0.25 * lq_facets_density(surface.lobe, wm) / lq_coated_lobe_share(surface);
}

// A cosine-weighted direction (exact), or the normal mirrored by a facet (ggx).
vec3 lq_coated_base_sample(const LqCoatedSurface surface, const vec2 u) {
    if (surface.base_lobe == LQ_BASE_LOBE_GGX) {
        const float share = u.x * lq_coated_lobe_share(surface);
        const float tan2_theta_m = lq_square(surface.lobe.alpha_x) * share / (1.0 - share);
        const float cos2_theta_m = 1.0 / (1.0 + tan2_theta_m);
        const vec2 azimuth = lq_cos_sin_turn(u.y);
        const float sine = 2.0 * cos2_theta_m * lq_safe_sqrt(tan2_theta_m);
        return vec3(sine * azimuth.x, sine * azimuth.y, max(2.0 * cos2_theta_m - 1.0, 0.0));
    }
    return lq_sample_cosine_hemisphere(u);
}

#endif
