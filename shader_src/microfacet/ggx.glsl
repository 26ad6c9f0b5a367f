// The GGX (Trowbridge-Reitz) distribution of facet normals with Smith masking; anisotropic.
// Based on: Walter et al. 2007, Microfacet Models for Refraction through Rough Surfaces;
//           Heitz 2014, Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs
#ifndef LQ_MICROFACET_GGX_GLSL
#define LQ_MICROFACET_GGX_GLSL

#include "../core/math.glsl"

// Density of facet normals wm (unit, upper hemisphere) per solid angle and projected area.
// Heitz 2014, Eq. 85.
float lq_ggx_density(const vec3 wm, const float alpha_x, const float alpha_y) {
    const float x = wm.x / alpha_x;
    const float y = wm.y / alpha_y;
    const float sum = x * x + y * y + wm.z * wm.z;
    return 1.0 / (LQ_PI * alpha_x * alpha_y * sum * sum);
}

// Smith's Lambda times the cosine, cos_theta Lambda(w) (Heitz 2014, Eq. 86), for w above the
// surface. Unlike Lambda it stays finite at grazing, and in this form it loses no digits at normal
// incidence, where sqrt(1 + x) - 1 would.
float lq_ggx_projected_lambda(const vec3 w, const float alpha_x, const float alpha_y) {
    const float x = alpha_x * w.x;
    const float y = alpha_y * w.y;
    const float slope_squared = x * x + y * y;
    const float root = sqrt(slope_squared + w.z * w.z);
    return 0.5 * slope_squared / max(root + w.z, LQ_MIN_COSINE_PRODUCT);
}

// Facet normal with the density of those visible from w:
//     D_w(wm) = max(0, dot(w, wm)) D(wm) / (cos_theta (1 + Lambda(w))).
// In the space where facets are spheres the visible normals are those halfway between w and a
// uniform point of a spherical cap.
// Based on: Dupuy and Benyoub 2023, Sampling Visible GGX Normals with Spherical Caps
vec3 lq_ggx_sample_visible_normal(const vec3 w, const float alpha_x, const float alpha_y,
                                  const vec2 u) {
    const vec3 stretched = normalize(vec3(alpha_x * w.x, alpha_y * w.y, w.z));
    const vec2 direction = lq_cos_sin_turn(u.x);
    const float height = (1.0 - u.y) * (1.0 + stretched.z) - stretched.z;
    const float radius = lq_sine_from_cosine(clamp(height, -1.0, 1.0));
    const vec3 halfway = vec3(radius * direction.x + stretched.x,
                              radius * direction.y + stretched.y,
                              max(height + stretched.z, LQ_MIN_COSINE_PRODUCT));
    return normalize(vec3(alpha_x * halfway.x, alpha_y * halfway.y, halfway.z));
}

#endif
