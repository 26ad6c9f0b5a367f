// Reflectance of a smooth boundary between two dielectrics, unpolarised light.
// Based on: Born and Wolf 1999, Principles of Optics, section 1.5
#ifndef LQ_FRESNEL_DIELECTRIC_GLSL
#define LQ_FRESNEL_DIELECTRIC_GLSL

#include "../core/math.glsl"

// Fresnel reflectance for cos_theta_i in [0, 1], eta = ior transmitted / ior incident; 1 beyond the
// critical angle.
//
// With g = eta cos_theta_t, g^2 = eta^2 - 1 + cos_theta_i^2, the amplitudes
//     r_s = (c - g) / (c + g),    r_p = (eta^2 c - g) / (eta^2 c + g)
// lose all digits in their numerators as eta nears 1. Multiplied by their own denominators these
// become (1 - eta^2) and (eta^2 - 1) (c^2 (eta^2 + 1) - 1), which do not.
float lq_fresnel_dielectric(const float cos_theta_i, const float eta) {
    const float c = clamp(cos_theta_i, 0.0, 1.0);
    const float contrast = (eta - 1.0) * (eta + 1.0);
    const float g_squared = contrast + c * c;
    if (g_squared <= 0.0) {
        return 1.0;
    }
    const float g = sqrt(g_squared);
    const float denominator_s = c + g;
    const float denominator_p = eta * eta * c + g;
    const float amplitude_s = contrast / (denominator_s * denominator_s);
    const float amplitude_p =
        contrast * (c * c * (eta * eta + 1.0) - 1.0) / (denominator_p * denominator_p);
    return min(0.5 * (amplitude_s * amplitude_s + amplitude_p * amplitude_p), 1.0);
}

// 1 - `lq_fresnel_dielectric`, by the transmitted parts themselves: subtracted from 1, little of a
// transmittance near grazing would be left.
float lq_transmittance_dielectric(const float cos_theta_i, const float eta) {
    const float c = clamp(cos_theta_i, 0.0, 1.0);
    const float g_squared = (eta - 1.0) * (eta + 1.0) + c * c;
    if (g_squared <= 0.0) {
        return 0.0;
    }
    const float g = sqrt(g_squared);
    const float denominator_s = c + g;
    const float denominator_p = eta * eta * c + g;
    return min(2.0 * c * g * (1.0 / (denominator_s * denominator_s) +
                              eta * eta / (denominator_p * denominator_p)), 1.0);
}

// cos_theta_t, the cosine between the refracted direction and the normal; 0 beyond the critical
// angle.
float lq_refracted_cosine(const float cos_theta_i, const float eta) {
    const float g_squared = (eta - 1.0) * (eta + 1.0) + cos_theta_i * cos_theta_i;
    return sqrt(max(g_squared, 0.0)) / eta;
}

#endif
