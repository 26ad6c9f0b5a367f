// The clear coat of glTF: one Fresnel factor per viewer, Schlick's, divides the light between the
// coat's lobe and the base, which is otherwise as if bare. Not reciprocal; light neither reflects
// within the coat nor is absorbed by it. Without a coat it is the base.
// Based on: Khronos Group 2020, KHR_materials_clearcoat (clearcoatFactor 1)
// Differs: F0 is that of the coat's own ior, which glTF fixes at 1.5.
#ifndef LQ_CLEARCOAT_CLEARCOAT_GLSL
#define LQ_CLEARCOAT_CLEARCOAT_GLSL

#include "../one_coat/lobes.glsl"

// The surface with every parameter brought into its range: call it once per shading point.
LqOneCoat lq_clearcoat_prepare(const LqOneCoat surface) {
    return lq_one_coat_prepare(surface);
}

// Share of the light that is the coat's, for a viewer at cos_theta_o: Schlick's reflectance. 0
// without a coat.
float lq_clearcoat_fresnel(const LqOneCoat surface, const float cos_theta_o) {
    if (surface.coat_eta <= 0.0) {
        return 0.0;
    }
    const float amplitude = (surface.coat_eta - 1.0) / (surface.coat_eta + 1.0);
    const float at_normal = amplitude * amplitude;
    const float m = clamp(1.0 - cos_theta_o, 0.0, 1.0);
    const float m_squared = m * m;
    return at_normal + (1.0 - at_normal) * m_squared * m_squared * m;
}

// f(wi, wo), per steradian; 0 unless both directions are above the surface. `surface` prepared.
vec3 lq_clearcoat_eval(const LqOneCoat surface, const vec3 wi, const vec3 wo) {
    if (!lq_is_above(wi)) {
        return vec3(0.0);
    }
    if (!lq_is_above(wo)) {
        return vec3(0.0);
    }
    const vec3 base = lq_base_lobe(surface, wi, wo, 1.0);
    if (surface.coat_eta <= 0.0) {
        return base;
    }
    const float fresnel = lq_clearcoat_fresnel(surface, wo.z);
    return base * (1.0 - fresnel) + vec3(fresnel * lq_reflection_lobe(surface.coat, wi, wo));
}

// f(wi, wo) cos_theta_i.
vec3 lq_clearcoat_eval_cos(const LqOneCoat surface, const vec3 wi, const vec3 wo) {
    return lq_clearcoat_eval(surface, wi, wo) * max(wi.z, 0.0);
}

// How often `lq_clearcoat_sample` chooses the coat for this wo: in proportion to what the coat and the
// base would reflect were they smooth.
float lq_clearcoat_coat_choice(const LqOneCoat surface, const vec3 wo) {
    const float fresnel = lq_clearcoat_fresnel(surface, wo.z);
    const float base = lq_average(lq_base_reflectance(surface, wo.z, 1.0));
    return lq_coat_choice(surface, fresnel, (1.0 - fresnel) * base);
}

// Density per solid angle with which `lq_clearcoat_sample` chooses wi; 0 unless both directions
// are above the surface. `surface` prepared.
float lq_clearcoat_pdf(const LqOneCoat surface, const vec3 wi, const vec3 wo) {
    if (!lq_is_above(wi)) {
        return 0.0;
    }
    if (!lq_is_above(wo)) {
        return 0.0;
    }
    return lq_one_coat_pdf(surface, lq_clearcoat_coat_choice(surface, wo), wi, wo);
}

// Direction of light for a viewer at wo, from three uniform numbers in [0, 1): the first chooses
// the lobe, the others the direction within it. `surface` prepared.
LqSample lq_clearcoat_sample(const LqOneCoat surface, const vec3 wo, const vec3 u) {
    if (!lq_is_above(wo)) {
        return LqSample(vec3(0.0, 0.0, 1.0), vec3(0.0), 0.0);
    }
    const float coat_choice = lq_clearcoat_coat_choice(surface, wo);
    const vec3 wi = lq_one_coat_direction(surface, coat_choice, wo, u);
    const float pdf = lq_clearcoat_pdf(surface, wi, wo);
    if (pdf <= 0.0) {
        return LqSample(wi, vec3(0.0), 0.0);
    }
    return LqSample(wi, lq_clearcoat_eval_cos(surface, wi, wo) * (1.0 / pdf), pdf);
}

// Fraction of light from every direction that the coat and the base send to wo, by averaging
// `point_count` low-discrepancy samples of each (256 give about three digits). `surface` prepared.
LqAlbedo lq_clearcoat_albedo(const LqOneCoat surface, const vec3 wo, const int point_count) {
    if (!lq_is_above(wo)) {
        return lq_no_albedo();
    }
    const float fresnel = lq_clearcoat_fresnel(surface, wo.z);
    const float share = 1.0 / float(max(point_count, 1));
    float direct = 0.0;
    for (int index = 0; index < point_count; index++) {
        const vec2 square = lq_low_discrepancy_point(uint(index));
        const vec3 wi = lq_reflection_sample(surface.coat, wo, square);
        direct += share * fresnel * lq_shown_fraction(surface.coat, wi, wo);
    }
    return lq_opaque_albedo(vec3(direct),
                    lq_base_albedo(surface, wo, point_count) * (1.0 - fresnel));
}

#endif
