// The shading that most engines do today: the coat's single reflections plus the base as if it were
// bare. No light passes from one to the other, so a coated base is too bright and nothing keeps
// energy; it is the baseline that the layered models are measured against.
// Based on: Walter et al. 2007, Microfacet Models for Refraction through Rough Surfaces
#ifndef LQ_PLAIN_PLAIN_GLSL
#define LQ_PLAIN_PLAIN_GLSL

#include "../core/frame.glsl"
#include "../core/sampling.glsl"
#include "../fresnel/conductor.glsl"
#include "../fresnel/dielectric.glsl"
#include "../microfacet/reflection.glsl"
#include "surface.glsl"

// `wi` unit, `weight` = f cos_theta_i / pdf, `pdf` per solid angle. A sample that reflects nothing
// has weight 0; its pdf is 0 where wi points below the surface.
struct LqSample {
    vec3 wi;
    vec3 weight;
    float pdf;
};

// Directional albedo split by where the light turned back: at the coat or at the base.
struct LqAlbedo {
    vec3 direct;
    vec3 base;
};

// A lobe is sampled at least this often where it reflects anything, so that weights stay bounded.
const float LQ_PLAIN_MIN_CHOICE = 0.1;

// The coat's part of f. `surface` prepared; wi and wo above the surface.
float lq_plain_coat(const LqPlainSurface surface, const vec3 wi, const vec3 wo) {
    if (surface.coat_eta <= 0.0) {
        return 0.0;
    }
    return lq_fresnel_dielectric(lq_cos_theta_halfway(wi, wo), surface.coat_eta) *
           lq_reflection_lobe(surface.coat, wi, wo);
}

// The base's part of f, as if no coat lay over it. `surface` prepared; wi and wo above the surface.
vec3 lq_plain_base(const LqPlainSurface surface, const vec3 wi, const vec3 wo) {
    if (surface.base == LQ_BASE_LAMBERTIAN) {
        return surface.albedo * LQ_INVERSE_PI;
    }
    if (surface.base == LQ_BASE_CONDUCTOR) {
        const float cos_theta = lq_cos_theta_halfway(wi, wo);
        return lq_fresnel_conductor_rgb(cos_theta, surface.eta, surface.kappa) *
               lq_reflection_lobe(surface.base_facets, wi, wo);
    }
    return vec3(0.0);
}

// f(wi, wo), per steradian; 0 unless both directions are above the surface. `surface` prepared.
vec3 lq_plain_eval(const LqPlainSurface surface, const vec3 wi, const vec3 wo) {
    if (!lq_is_above(wi)) {
        return vec3(0.0);
    }
    if (!lq_is_above(wo)) {
        return vec3(0.0);
    }
    return lq_plain_base(surface, wi, wo) + vec3(lq_plain_coat(surface, wi, wo));
}

// f(wi, wo) cos_theta_i.
vec3 lq_plain_eval_cos(const LqPlainSurface surface, const vec3 wi, const vec3 wo) {
    return lq_plain_eval(surface, wi, wo) * max(wi.z, 0.0);
}

// How often `lq_plain_sample` chooses the coat for this wo: in proportion to what the coat and the
// base would reflect were they smooth.
float lq_plain_coat_choice(const LqPlainSurface surface, const vec3 wo) {
    if (surface.coat_eta <= 0.0) {
        return 0.0;
    }
    if (surface.base == LQ_BASE_NONE) {
        return 1.0;
    }
    const float coat = lq_fresnel_dielectric(wo.z, surface.coat_eta);
    float base = lq_average(surface.albedo);
    if (surface.base == LQ_BASE_CONDUCTOR) {
        base = lq_average(lq_fresnel_conductor_rgb(wo.z, surface.eta, surface.kappa));
    }
    return clamp(coat / (coat + base + LQ_MIN_COSINE_PRODUCT), LQ_PLAIN_MIN_CHOICE,
                 1.0 - LQ_PLAIN_MIN_CHOICE);
}

// Density per solid angle with which `lq_plain_sample` chooses wi; 0 unless both directions are
// above the surface. `surface` prepared.
float lq_plain_pdf(const LqPlainSurface surface, const vec3 wi, const vec3 wo) {
    if (!lq_is_above(wi)) {
        return 0.0;
    }
    if (!lq_is_above(wo)) {
        return 0.0;
    }
    const float coat_choice = lq_plain_coat_choice(surface, wo);
    float pdf = 0.0;
    if (coat_choice > 0.0) {
        pdf = coat_choice * lq_reflection_pdf(surface.coat, wi, wo);
    }
    if (surface.base == LQ_BASE_LAMBERTIAN) {
        pdf += (1.0 - coat_choice) * lq_cosine_hemisphere_pdf(wi.z);
    }
    if (surface.base == LQ_BASE_CONDUCTOR) {
        pdf += (1.0 - coat_choice) * lq_reflection_pdf(surface.base_facets, wi, wo);
    }
    return pdf;
}

// Direction of light for a viewer at wo, from three uniform numbers in [0, 1): the first chooses
// the lobe, the others the direction within it. `surface` prepared.
LqSample lq_plain_sample(const LqPlainSurface surface, const vec3 wo, const vec3 u) {
    if (!lq_is_above(wo)) {
        return LqSample(vec3(0.0, 0.0, 1.0), vec3(0.0), 0.0);
    }
    const vec2 square = vec2(u.y, u.z);
    vec3 wi = vec3(0.0, 0.0, 1.0);
    if (u.x < lq_plain_coat_choice(surface, wo)) {
        wi = lq_reflection_sample(surface.coat, wo, square);
    } else {
        if (surface.base == LQ_BASE_CONDUCTOR) {
            wi = lq_reflection_sample(surface.base_facets, wo, square);
        } else {
            wi = lq_sample_cosine_hemisphere(square);
        }
    }
    const float pdf = lq_plain_pdf(surface, wi, wo);
    if (pdf <= 0.0) {
        return LqSample(wi, vec3(0.0), 0.0);
    }
    return LqSample(wi, lq_plain_eval_cos(surface, wi, wo) * (1.0 / pdf), pdf);
}

// Fraction of light from every direction that the coat and the base send to wo, by averaging
// `point_count` low-discrepancy samples of each (256 give about three digits). `surface` prepared.
LqAlbedo lq_plain_albedo(const LqPlainSurface surface, const vec3 wo, const int point_count) {
    LqAlbedo albedo = LqAlbedo(vec3(0.0), vec3(0.0));
    if (!lq_is_above(wo)) {
        return albedo;
    }
    if (surface.base == LQ_BASE_LAMBERTIAN) {
        albedo.base = surface.albedo;
    }
    const float share = 1.0 / float(max(point_count, 1));
    for (int index = 0; index < point_count; index++) {
        const vec2 square = lq_low_discrepancy_point(uint(index));
        if (surface.coat_eta > 0.0) {
            const vec3 wi = lq_reflection_sample(surface.coat, wo, square);
            if (lq_is_above(wi)) {
                const float shown = lq_facets_masking_shadowing(surface.coat, wi, wo) /
                                    lq_facets_masking(surface.coat, wo);
                const float cos_theta = lq_cos_theta_halfway(wi, wo);
                albedo.direct += vec3(
                    share * shown * lq_fresnel_dielectric(cos_theta, surface.coat_eta));
            }
        }
        if (surface.base == LQ_BASE_CONDUCTOR) {
            const vec3 wi = lq_reflection_sample(surface.base_facets, wo, square);
            if (lq_is_above(wi)) {
                const float shown = lq_facets_masking_shadowing(surface.base_facets, wi, wo) /
                                    lq_facets_masking(surface.base_facets, wo);
                const float cos_theta = lq_cos_theta_halfway(wi, wo);
                albedo.base += lq_fresnel_conductor_rgb(cos_theta, surface.eta, surface.kappa) *
                               (share * shown);
            }
        }
    }
    return albedo;
}

#endif
