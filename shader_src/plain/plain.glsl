// The shading that most engines do today: the coat's single reflections plus the base as if it were
// bare. No light passes from one to the other, so a coated base is too bright and nothing keeps
// energy; it is the baseline that the layered models are measured against. The coat's medium does
// not absorb.
// Based on: Walter et al. 2007, Microfacet Models for Refraction through Rough Surfaces
#ifndef LQ_PLAIN_PLAIN_GLSL
#define LQ_PLAIN_PLAIN_GLSL

#include "../one_coat/lobes.glsl"

// The surface with every parameter brought into its range: call it once per shading point.
LqOneCoat lq_plain_prepare(const LqOneCoat surface) {
    return lq_one_coat_prepare(surface);
}

// f(wi, wo), per steradian; 0 unless both directions are above the surface. `surface` prepared.
vec3 lq_plain_eval(const LqOneCoat surface, const vec3 wi, const vec3 wo) {
    if (!lq_is_above(wi)) {
        return vec3(0.0);
    }
    if (!lq_is_above(wo)) {
        return vec3(0.0);
    }
    return lq_base_lobe(surface, wi, wo, 1.0) + vec3(lq_coat_lobe(surface, wi, wo));
}

// f(wi, wo) cos_theta_i.
vec3 lq_plain_eval_cos(const LqOneCoat surface, const vec3 wi, const vec3 wo) {
    return lq_plain_eval(surface, wi, wo) * max(wi.z, 0.0);
}

// How often `lq_plain_sample` chooses the coat for this wo: in proportion to what the coat and the
// base would reflect were they smooth.
float lq_plain_coat_choice(const LqOneCoat surface, const vec3 wo) {
    return lq_coat_choice(surface, lq_fresnel_dielectric(wo.z, surface.coat_eta),
                          lq_average(lq_base_reflectance(surface, wo.z, 1.0)));
}

// Density per solid angle with which `lq_plain_sample` chooses wi; 0 unless both directions are
// above the surface. `surface` prepared.
float lq_plain_pdf(const LqOneCoat surface, const vec3 wi, const vec3 wo) {
    if (!lq_is_above(wi)) {
        return 0.0;
    }
    if (!lq_is_above(wo)) {
        return 0.0;
    }
    return lq_one_coat_pdf(surface, lq_plain_coat_choice(surface, wo), wi, wo);
}

// Direction of light for a viewer at wo, from three uniform numbers in [0, 1): the first chooses
// the lobe, the others the direction within it. `surface` prepared.
LqSample lq_plain_sample(const LqOneCoat surface, const vec3 wo, const vec3 u) {
    if (!lq_is_above(wo)) {
        return LqSample(vec3(0.0, 0.0, 1.0), vec3(0.0), 0.0);
    }
    const float coat_choice = lq_plain_coat_choice(surface, wo);
    const vec3 wi = lq_one_coat_direction(surface, coat_choice, wo, u);
    const float pdf = lq_plain_pdf(surface, wi, wo);
    if (pdf <= 0.0) {
        return LqSample(wi, vec3(0.0), 0.0);
    }
    return LqSample(wi, lq_plain_eval_cos(surface, wi, wo) * (1.0 / pdf), pdf);
}

// Fraction of light from every direction that the coat and the base send to wo, by averaging
// `point_count` low-discrepancy samples of each (256 give about three digits). `surface` prepared.
LqAlbedo lq_plain_albedo(const LqOneCoat surface, const vec3 wo, const int point_count) {
    if (!lq_is_above(wo)) {
        return lq_no_albedo();
    }
    return lq_opaque_albedo(vec3(lq_coat_albedo(surface, wo, point_count)),
                    lq_base_albedo(surface, wo, point_count));
}

#endif
