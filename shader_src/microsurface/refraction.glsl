// A facet that refracts: the normal that sends one direction to another, and where it sends it.
// Directions: wo above the surface, wi below; `eta` is the index below over that above, not 1.
// Based on: Walter et al. 2007, Microfacet Models for Refraction through Rough Surfaces
#ifndef LQ_MICROSURFACE_REFRACTION_GLSL
#define LQ_MICROSURFACE_REFRACTION_GLSL

#include "../core/math.glsl"
#include "../fresnel/dielectric.glsl"

// `jacobian`: solid angle of the normals that refract wo into a solid angle of wi, over dot(wo, wm),
// Eq. 17. `cos_theta` is dot(wo, wm), and 0 where no facet refracts one into the other.
struct LqRefraction {
    vec3 wm;
    float cos_theta;
    float jacobian;
};

// Eq. 16.
LqRefraction lq_refraction(const vec3 wi, const vec3 wo, const float eta) {
    const vec3 sum = wo + wi * eta;
    const float length_squared = max(dot(sum, sum), LQ_MIN_COSINE_PRODUCT);
    const vec3 wm = sum * ((sum.z < 0.0 ? -1.0 : 1.0) / sqrt(length_squared));
    const float cos_theta_o = dot(wo, wm);
    const float cos_theta_i = -dot(wi, wm);
    if (cos_theta_o <= 0.0) {
        return LqRefraction(vec3(0.0, 0.0, 1.0), 0.0, 0.0);
    }
    if (cos_theta_i <= 0.0) {
        return LqRefraction(vec3(0.0, 0.0, 1.0), 0.0, 0.0);
    }
    return LqRefraction(wm, cos_theta_o, eta * eta * cos_theta_i / length_squared);
}

// wo refracted by a facet of normal wm that faces it; it may point above the surface. Of light beyond
// the critical angle none is refracted: then along the facet.
vec3 lq_refracted(const vec3 wo, const vec3 wm, const float eta) {
    const float cos_theta = dot(wo, wm);
    return wm * (cos_theta / eta - lq_refracted_cosine(cos_theta, eta)) - wo / eta;
}

#endif
