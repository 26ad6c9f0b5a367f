// The light that comes back through the coat from the base below it.
// Based on: de Dinechin and Belcour 2022, Rendering Layered Materials with Diffuse Interfaces,
//           Eq. 3 (its energy), Eq. 5 (the GGX lobe)
#ifndef LQ_COATED_BASE_LOBE_GLSL
#define LQ_COATED_BASE_LOBE_GLSL

#include "../core/sampling.glsl"
#include "surface.glsl"

// sin^2_theta, of a unit vector.
float lq_coated_sine_squared(const vec3 w) {
    return w.x * w.x + w.y * w.y;
}

// D of the facet that mirrors the normal to wi, in closed form: half the angle between the two has
// cos^2 = (1 + c) / 2 and sin^2 = (1 - c) / 2, c = cos_theta_i.
float lq_coated_lobe_density(const float alpha, const vec3 wi) {
    const float alpha_squared = lq_square(alpha);
    const float sum = 1.0 + wi.z;
    const float difference = lq_coated_sine_squared(wi) / sum;  // 1 - c with all its digits
    const float width = 0.5 * (sum * alpha_squared + difference);
    return LQ_INVERSE_PI * alpha_squared / max(lq_square(width), LQ_MIN_COSINE_PRODUCT);
}

// D G1(wi) / (4 cos_theta_i): all of it for a viewer along the normal, from where no facet hides.
float lq_coated_normal_lobe(const float alpha, const vec3 wi) {
    const float root = sqrt(lq_square(wi.z) + lq_square(alpha) * lq_coated_sine_squared(wi));
    return 0.5 * lq_coated_lobe_density(alpha, wi) / max(wi.z + root, LQ_MIN_COSINE_PRODUCT);
}

// The base's part of f, for wi and the viewer above the surface.
// Exact: T01(wi) T01(wo) rho / (pi eta^2 (1 - rho R10_bar)): a Lambertian base forgets directions,
// and light takes the same paths both ways.
vec3 lq_coated_base(const LqCoatedSurface surface, const LqCoatedView viewer, const vec3 wi) {
    if (surface.base_lobe == LQ_BASE_LOBE_GGX) {
        return viewer.base * (lq_coated_normal_lobe(surface.lobe_alpha, wi) / surface.lobe_energy);
    }
    const vec4 entering = lq_interface_t_down(surface.energies, min(wi.z, 1.0));
    return vec3(entering.x, entering.y, entering.z) * (viewer.entering * surface.spread);
}

// Of the facets as seen along the normal, those that mirror it above the surface.
float lq_coated_lobe_share(const LqCoatedSurface surface) {
    return 1.0 / (1.0 + lq_square(surface.lobe_alpha));
}

// Density of `lq_coated_base_sample`, which does not depend on the viewer; wi above the surface.
float lq_coated_base_pdf(const LqCoatedSurface surface, const vec3 wi) {
    if (surface.base_lobe == LQ_BASE_LOBE_EXACT) {
        return lq_cosine_hemisphere_pdf(wi.z);
    }
    return 0.25 * lq_coated_lobe_density(surface.lobe_alpha, wi) / lq_coated_lobe_share(surface);
}

// A cosine-weighted direction (exact), or the normal mirrored by a facet (ggx).
vec3 lq_coated_base_sample(const LqCoatedSurface surface, const vec2 u) {
    if (surface.base_lobe == LQ_BASE_LOBE_GGX) {
        const float share = u.x * lq_coated_lobe_share(surface);
        const float tan2_theta_m = lq_square(surface.lobe_alpha) * share / (1.0 - share);
        const float cos2_theta_m = 1.0 / (1.0 + tan2_theta_m);
        const vec2 azimuth = lq_cos_sin_turn(u.y);
        const float sine = 2.0 * cos2_theta_m * lq_safe_sqrt(tan2_theta_m);
        return vec3(sine * azimuth.x, sine * azimuth.y, max(2.0 * cos2_theta_m - 1.0, 0.0));
    }
    return lq_sample_cosine_hemisphere(u);
}

#endif
