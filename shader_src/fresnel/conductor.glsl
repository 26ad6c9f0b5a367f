// Reflectance of a smooth boundary between a dielectric and a conductor, unpolarised light.
// Based on: Born and Wolf 1999, Principles of Optics, section 14.2
#ifndef LQ_FRESNEL_CONDUCTOR_GLSL
#define LQ_FRESNEL_CONDUCTOR_GLSL

#include "../core/math.glsl"

// Keep 0 / 0 away: at exactly grazing incidence on a boundary without contrast, and at normal
// incidence on an index of 0, whose reflectance is 1 like that of any index near it.
const float LQ_MIN_FRESNEL_COSINE = 1.0e-12;
const float LQ_MIN_FRESNEL_TERM = 1.0e-30;

// Fresnel reflectance for cos_theta_i in [0, 1] and a conductor of index eta + i kappa (kappa >= 0)
// relative to the medium of incidence.
//
// The refracted normal component is (a + i b), with a^2 - b^2 = eta^2 - kappa^2 - sin^2 theta_i and
// a b = eta kappa. The difference is taken from 1 on both sides, or at grazing an index near the
// exterior's would leave nothing but rounding. The larger of a and b comes from a sum of positive terms and the other from the
// product: the textbook's difference of near-equal terms loses four digits for noble metals.
float lq_fresnel_conductor(const float cos_theta_i, const float eta, const float kappa) {
    const float c = clamp(cos_theta_i, LQ_MIN_FRESNEL_COSINE, 1.0);
    const float sin_squared = (1.0 - c) * (1.0 + c);
    const float difference = (eta - 1.0) * (eta + 1.0) - kappa * kappa + c * c;
    const float product = eta * kappa;
    const float larger = sqrt(0.5 * (sqrt(difference * difference + 4.0 * product * product) +
                                     abs(difference)));
    const float smaller = larger > 0.0 ? product / larger : 0.0;
    const float a = difference >= 0.0 ? larger : smaller;
    const float b = difference >= 0.0 ? smaller : larger;
    const float s_part = ((a - c) * (a - c) + b * b) / ((a + c) * (a + c) + b * b);
    const float p_minus = a * c - sin_squared;
    const float p_plus = a * c + sin_squared;
    const float offset = b * b * c * c + LQ_MIN_FRESNEL_TERM;
    const float p_part = (p_minus * p_minus + offset) / (p_plus * p_plus + offset);
    return min(0.5 * s_part * (1.0 + p_part), 1.0);
}

// The same for an index per colour channel.
vec3 lq_fresnel_conductor_rgb(const float cos_theta_i, const vec3 eta, const vec3 kappa) {
    return vec3(lq_fresnel_conductor(cos_theta_i, eta.x, kappa.x),
                lq_fresnel_conductor(cos_theta_i, eta.y, kappa.y),
                lq_fresnel_conductor(cos_theta_i, eta.z, kappa.z));
}

#endif
