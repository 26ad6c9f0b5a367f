// What the first facets that light meets leave of it to others: by quadrature over them, for
// directions in the planes of x and y.
#ifndef LQ_MICROSURFACE_LEFT_OVER_GLSL
#define LQ_MICROSURFACE_LEFT_OVER_GLSL

#include "facet_points.glsl"
#include "single_scattering.glsl"

// Fractions of light along w: what meets another facet if the first absorbs nothing, and the same
// without what the first absorbs.
struct LqLeftOver {
    float met;
    vec3 kept;
};

// Of the area of the n-th stratum, what sees w.
float lq_seen_of_stratum(const LqStrata strata, const int n, const vec3 w) {
    const float mixed = lq_mixed_cosines(strata, w);
    LqVisibility visible = lq_nothing_passed_yet();
    for (int looked = 0; looked <= n; looked++) {
        const LqPlacedStratum stratum = lq_stratum_at(strata, looked);
        const float cosines = w.z + lq_facets_projected_lambda(stratum.facets, w);
        visible = lq_next_visibility(visible, strata.blend, stratum, cosines, mixed, w.z);
    }
    return visible.here * w.z;
}

// What sees w and, mirrored by a facet of it, the sky.
float lq_mirrored_up(const LqStrata strata, const int n, const vec3 w, const LqFacetPoint facet) {
    const vec3 away = facet.wm * (2.0 * facet.cos_theta) - w;
    if (away.z <= 0.0) {
        return 0.0;
    }
    const float mixed = lq_mixed_cosines_both(strata, away, w);
    LqVisibility visible = lq_nothing_passed_yet();
    for (int reached = 0; reached <= n; reached++) {
        const LqPlacedStratum stratum = lq_stratum_at(strata, reached);
        const float cosines = lq_facets_cosines_over_masking_shadowing(stratum.facets, away, w);
        visible = lq_next_visibility(visible, strata.blend, stratum, cosines, mixed, away.z * w.z);
    }
    return visible.here * away.z * w.z;
}

// What sees w and, refracted, the far side.
float lq_refracted_down(const LqStrata strata, const int n, const vec3 w, const LqFacetPoint facet,
                        const float eta) {
    const vec3 away = lq_refracted(w, facet.wm, eta);
    if (away.z >= 0.0) {
        return 0.0;
    }
    const vec3 down = vec3(away.x, away.y, -away.z);
    const LqFacets facets = lq_stratum_at(strata, n).facets;
    const bool is_mixed = strata.blend == LQ_BLEND_SYMMETRIC;
    float passed = 1.0;
    for (int above = 0; above < n; above++) {
        const LqPlacedStratum stratum = lq_stratum_at(strata, above);
        passed *= exp(stratum.log_up *
                      lq_beta_lambda(lq_facets_projected_lambda(stratum.facets, w), w.z));
    }
    const float lambda_up =
        is_mixed ? lq_mixed_projected_lambda(strata, w) : lq_facets_projected_lambda(facets, w);
    const float lambda_down = is_mixed ? lq_mixed_projected_lambda(strata, down)
                                       : lq_facets_projected_lambda(facets, down);
    return lq_visible_through(strata, n, lambda_up, lambda_down, passed, w, down) * w.z * down.z;
}

// Of conductors. The reflectances of facets count by what each leaves over.
LqLeftOver lq_left_by_mirrors(const LqRoughSide side, const int n, const vec3 w) {
    const LqPlacedStratum stratum = lq_stratum_at(side.strata, n);
    const float visible = lq_seen_of_stratum(side.strata, n, w);
    float sent = 0.0;
    float weights = 0.0;
    vec3 reflectances = vec3(0.0);
    for (int towards = 0; towards < LQ_FACET_RAYS; towards++) {
        const LqSlopeRay ray = lq_slope_ray(stratum.facets, w, towards);
        for (int level = 0; level < LQ_FACET_HEIGHTS + LQ_STEEP_HEIGHTS; level++) {
            const bool is_steep = level >= LQ_FACET_HEIGHTS;
            const float horizon = lq_horizon_height(ray, w);
            const float low = is_steep ? horizon : 0.0;
            const float high = is_steep ? lq_grazed_height(ray, w) : horizon;
            const vec2 steep_rule = lq_gauss_two(max(level - LQ_FACET_HEIGHTS, 0));
            const vec2 flat_rule = lq_gauss_six(min(level, LQ_FACET_HEIGHTS - 1));
            const vec2 rule = vec2(is_steep ? steep_rule.x : flat_rule.x,
                                   is_steep ? steep_rule.y : flat_rule.y);
            const LqFacetPoint facet = lq_facet_point(stratum.facets, w, ray, low, high, rule);
            const float away =
                is_steep ? 0.0 : lq_mirrored_up(side.strata, n, w, facet);
            const float rest = facet.weight * (visible - away);
            sent += facet.weight * away;
            weights += rest;
            reflectances +=
                rest * lq_fresnel_conductor_rgb(facet.cos_theta, stratum.eta, stratum.kappa);
        }
    }
    const float met = visible * (w.z + lq_facets_projected_lambda(stratum.facets, w)) / w.z;
    const float rest_of_all = clamp(met - sent, 0.0, met);
    return LqLeftOver(rest_of_all,
                      reflectances * (rest_of_all / max(weights, LQ_MIN_COSINE_PRODUCT)));
}

// What facets let through at one point, less what they would mirror up of it.
float lq_through_instead(const LqRoughSide side, const int n, const vec3 w,
                         const LqFacetPoint facet, const bool mirrors_up) {
    const float away = mirrors_up ? lq_mirrored_up(side.strata, n, w, facet) : 0.0;
    return facet.weight * lq_transmittance_dielectric(facet.cos_theta, side.eta) *
           (lq_refracted_down(side.strata, n, w, facet, side.eta) - away);
}

// Sent to either side by one stratum of facets that refract: mirrored as if nothing were let
// through, and what is let through instead.
float lq_sent_by_interfaces(const LqRoughSide side, const int n, const vec3 w) {
    const LqFacets facets = lq_stratum_at(side.strata, n).facets;
    const bool is_dense = side.eta < 1.0;
    const float critical_cosine = lq_safe_sqrt((1.0 - side.eta) * (1.0 + side.eta));
    float sent = 0.0;
    for (int around = 0; around < LQ_FACET_RAYS; around++) {
        const LqSlopeRay ray = lq_slope_ray(facets, w, around);
        for (int up = 0; up < LQ_FACET_HEIGHTS; up++) {
            const LqFacetPoint facet = lq_facet_point_mirroring_up(facets, w, ray, up);
            sent += facet.weight * lq_mirrored_up(side.strata, n, w, facet);
            if (!is_dense) {
                sent += lq_through_instead(side, n, w, facet, true);
            }
        }
        if (!is_dense) {
            for (int steep = 0; steep < LQ_STEEP_HEIGHTS; steep++) {
                sent += lq_through_instead(
                    side, n, w, lq_facet_point_mirroring_down(facets, w, ray, steep), false);
            }
        }
    }
    const int inner_rays = is_dense ? lq_rays_within(w, critical_cosine) : 0;
    for (int inside = 0; inside < inner_rays; inside++) {
        const LqSlopeRay inner = lq_slope_ray_within(facets, w, critical_cosine, inside);
        for (int cone = 0; cone < LQ_FACET_HEIGHTS; cone++) {
            sent += lq_through_instead(
                side, n, w, lq_facet_point_within(facets, w, inner, critical_cosine, cone), true);
        }
    }
    return sent;
}

LqLeftOver lq_left_over(const LqRoughSide side, const vec3 w) {
    float met = 0.0;
    vec3 kept = vec3(0.0);
    for (int own = 0; own < side.strata.count; own++) {
        if (side.eta > 0.0) {
            met += lq_sent_by_interfaces(side, own, w);
        } else {
            const LqLeftOver part = lq_left_by_mirrors(side, own, w);
            met += part.met;
            kept += part.kept;
        }
    }
    if (side.eta > 0.0) {
        met = clamp(1.0 - met, 0.0, 1.0);
        kept = vec3(met);
    }
    return LqLeftOver(met, kept);
}

#endif
