// Light that met one facet of a surface of several strata, in closed form. wo is above the surface.
// Based on: d'Eon et al. 2023, Microfacet Theory for Non-Uniform Heightfields
//
// Differs: any number of strata, from the top down, instead of a recursion on the lower one; and the
// normalisation of the light refracted (Eq. 20), which for equal strata is B(1 + Lambda(wi),
// 1 + Lambda(wo)).
#ifndef LQ_MICROSURFACE_SINGLE_SCATTERING_GLSL
#define LQ_MICROSURFACE_SINGLE_SCATTERING_GLSL

#include "../fresnel/conductor.glsl"
#include "../fresnel/dielectric.glsl"
#include "../microfacet/reflection.glsl"
#include "incomplete_beta.glsl"
#include "refraction.glsl"
#include "visibility.glsl"

// A surface as light meets it from one side. `eta`: index of the other side over that of this one,
// of facets that refract; 0 of conductors, whose strata have their own. `is_one_metal`: all strata
// have the index of the first.
struct LqRoughSide {
    LqStrata strata;
    float eta;
    bool is_one_metal;
};

// The other side of facets that refract.
LqRoughSide lq_rough_side_turned_over(const LqRoughSide side) {
    return LqRoughSide(lq_strata_turned_over(side.strata), 1.0 / side.eta, side.is_one_metal);
}

vec3 lq_facet_reflectance(const LqRoughSide side, const LqPlacedStratum stratum,
                          const float cos_theta) {
    if (side.eta > 0.0) {
        return vec3(lq_fresnel_dielectric(cos_theta, side.eta));
    }
    return lq_fresnel_conductor_rgb(cos_theta, stratum.eta, stratum.kappa);
}

// cos_theta (1 + Lambda), or of two directions their product times 1 + both Lambdas.
float lq_mixed_cosines(const LqStrata strata, const vec3 w) {
    return strata.blend == LQ_BLEND_SYMMETRIC ? w.z + lq_mixed_projected_lambda(strata, w) : 0.0;
}

float lq_mixed_cosines_both(const LqStrata strata, const vec3 wi, const vec3 wo) {
    if (strata.blend != LQ_BLEND_SYMMETRIC) {
        return 0.0;
    }
    return wi.z * wo.z + wo.z * lq_mixed_projected_lambda(strata, wi) +
           wi.z * lq_mixed_projected_lambda(strata, wo);
}

// f of light reflected from wi, above. Eq. 15.
vec3 lq_reflected_once(const LqRoughSide side, const vec3 wi, const vec3 wo) {
    const vec3 wm = lq_halfway(wi, wo);
    const float cos_theta = lq_cos_theta_halfway(wi, wo);
    const bool differs = side.eta <= 0.0 && !side.is_one_metal;
    const float mixed = lq_mixed_cosines_both(side.strata, wi, wo);
    LqVisibility visible = lq_nothing_passed_yet();
    float alike = 0.0;
    vec3 unlike = vec3(0.0);
    for (int met = 0; met < side.strata.count; met++) {
        const LqPlacedStratum stratum = lq_stratum_at(side.strata, met);
        const float cosines = lq_facets_cosines_over_masking_shadowing(stratum.facets, wi, wo);
        visible = lq_next_visibility(visible, side.strata.blend, stratum, cosines, mixed,
                                     wi.z * wo.z);
        const float facing = visible.here * lq_facets_density(stratum.facets, wm);
        if (differs) {
            unlike += facing * lq_facet_reflectance(side, stratum, cos_theta);
        } else {
            alike += facing;
        }
    }
    if (differs) {
        return 0.25 * unlike;
    }
    return (0.25 * alike) * lq_facet_reflectance(side, side.strata.first, cos_theta);
}

// The density of the normals visible from wo, over dot(wo, wm) where that is positive.
float lq_visible_density(const LqStrata strata, const vec3 wo, const vec3 wm) {
    const float mixed = lq_mixed_cosines(strata, wo);
    LqVisibility visible = lq_nothing_passed_yet();
    float density = 0.0;
    for (int seen = 0; seen < strata.count; seen++) {
        const LqPlacedStratum stratum = lq_stratum_at(strata, seen);
        const float cosines = wo.z + lq_facets_projected_lambda(stratum.facets, wo);
        visible = lq_next_visibility(visible, strata.blend, stratum, cosines, mixed, wo.z);
        density += visible.here * lq_facets_density(stratum.facets, wm);
    }
    return density;
}

// Lambda as lq_beta_between takes it.
float lq_beta_lambda(const float projected_lambda, const float cosine) {
    return min(projected_lambda / max(cosine, LQ_MIN_COSINE_PRODUCT), LQ_MAX_BETA_LAMBDA);
}

// What the strata below `n` let pass of rays downwards, of `down` mirrored to above the surface.
float lq_passed_downwards(const LqStrata strata, const int n, const vec3 down) {
    float passed = 1.0;
    for (int deeper = n + 1; deeper < strata.count; deeper++) {
        const LqPlacedStratum stratum = lq_stratum_at(strata, deeper);
        const float lambda = lq_beta_lambda(lq_facets_projected_lambda(stratum.facets, down), down.z);
        passed *= exp(stratum.log_down * lambda);
    }
    return passed;
}

// What is visible of the n-th stratum from wo above and from `down` below, mirrored to above, over
// both cosines; `passed` is what strata above it let pass of wo.
float lq_visible_through(const LqStrata strata, const int n, const float lambda_up,
                         const float lambda_down, const float passed, const vec3 wo,
                         const vec3 down) {
    const LqPlacedStratum stratum = lq_stratum_at(strata, n);
    const float up = lq_beta_lambda(lambda_up, wo.z);
    const float downwards = lq_beta_lambda(lambda_down, down.z);
    // The integral falls like 1 / (1 + Lambda) each: over both cosines that stays finite at grazing,
    // where Lambda is out of range.
    const float scale = (1.0 + up) * (1.0 + downwards) /
                        max((wo.z + lambda_up) * (down.z + lambda_down), LQ_MIN_COSINE_PRODUCT);
    if (strata.blend == LQ_BLEND_SYMMETRIC) {
        return scale * (stratum.high - stratum.low) * lq_beta_between(0.0, 1.0, up, downwards);
    }
    return scale * passed * lq_passed_downwards(strata, n, down) *
           lq_beta_between(stratum.low, stratum.high, up, downwards);
}

// f of light refracted from wi, below: for radiance over the square of the index, which refraction
// keeps. Eq. 21.
float lq_refracted_once(const LqRoughSide side, const vec3 wi, const vec3 wo) {
    const LqRefraction refraction = lq_refraction(wi, wo, side.eta);
    if (refraction.cos_theta <= 0.0) {
        return 0.0;
    }
    const vec3 down = vec3(wi.x, wi.y, -wi.z);
    const bool is_mixed = side.strata.blend == LQ_BLEND_SYMMETRIC;
    const float mixed_up = is_mixed ? lq_mixed_projected_lambda(side.strata, wo) : 0.0;
    const float mixed_down = is_mixed ? lq_mixed_projected_lambda(side.strata, down) : 0.0;
    float passed = 1.0;
    float sum = 0.0;
    for (int crossed = 0; crossed < side.strata.count; crossed++) {
        const LqPlacedStratum stratum = lq_stratum_at(side.strata, crossed);
        const float lambda_up =
            is_mixed ? mixed_up : lq_facets_projected_lambda(stratum.facets, wo);
        const float lambda_down =
            is_mixed ? mixed_down : lq_facets_projected_lambda(stratum.facets, down);
        sum += lq_visible_through(side.strata, crossed, lambda_up, lambda_down, passed, wo, down) *
               lq_facets_density(stratum.facets, refraction.wm);
        passed *= exp(stratum.log_up * lq_beta_lambda(lambda_up, wo.z));
    }
    return sum * lq_transmittance_dielectric(refraction.cos_theta, side.eta) *
           refraction.cos_theta * refraction.jacobian;
}

// Densities per solid angle of wi where wo is reflected or refracted by a visible normal, as its
// facet chooses.
float lq_reflected_pdf(const LqRoughSide side, const vec3 wi, const vec3 wo) {
    const float density = 0.25 * lq_visible_density(side.strata, wo, lq_halfway(wi, wo));
    if (side.eta > 0.0) {
        return density * lq_fresnel_dielectric(lq_cos_theta_halfway(wi, wo), side.eta);
    }
    return density;
}

float lq_refracted_pdf(const LqRoughSide side, const vec3 wi, const vec3 wo) {
    const LqRefraction refraction = lq_refraction(wi, wo, side.eta);
    if (refraction.cos_theta <= 0.0) {
        return 0.0;
    }
    return lq_visible_density(side.strata, wo, refraction.wm) *
           lq_transmittance_dielectric(refraction.cos_theta, side.eta) * refraction.cos_theta *
           refraction.jacobian;
}

// The greatest float below 1.
const float LQ_MOST_UNIFORM = 0.999999940395355;

// A normal visible from wo; `rest` is what choosing its stratum left of the random number, again in
// [0, 1).
struct LqVisibleNormal {
    vec3 wm;
    float rest;
};

// From u in [0, 1)^3: the first chooses a stratum by what of its facets' projected area is visible,
// the others one of its visible normals.
LqVisibleNormal lq_sample_visible_normal(const LqStrata strata, const vec3 wo, const vec3 u) {
    const float mixed = lq_mixed_cosines(strata, wo);
    LqVisibility visible = lq_nothing_passed_yet();
    LqFacets chosen = strata.first.facets;
    float rest = u.x;
    float before = 0.0;
    bool is_chosen = false;
    for (int choice = 0; choice < strata.count; choice++) {
        const LqPlacedStratum stratum = lq_stratum_at(strata, choice);
        const float cosines = wo.z + lq_facets_projected_lambda(stratum.facets, wo);
        visible = lq_next_visibility(visible, strata.blend, stratum, cosines, mixed, wo.z);
        const float probability = visible.here * cosines;
        const bool is_here = !is_chosen && (u.x < before + probability || choice + 1 == strata.count);
        if (is_here) {
            chosen = stratum.facets;
            rest = (u.x - before) / max(probability, LQ_MIN_COSINE_PRODUCT);
            is_chosen = true;
        }
        before += probability;
    }
    return LqVisibleNormal(
        lq_facets_sample_visible_normal(chosen, wo, vec2(u.y, u.z)),
        clamp(rest, 0.0, LQ_MOST_UNIFORM));
}

#endif
