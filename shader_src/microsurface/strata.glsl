// A rough surface of several populations of facets: one above the other (asymmetric), or mixed at
// every height (symmetric). Height is measured by C, the fraction of the surface below it.
// Based on: d'Eon et al. 2023, Microfacet Theory for Non-Uniform Heightfields
#ifndef LQ_MICROSURFACE_STRATA_GLSL
#define LQ_MICROSURFACE_STRATA_GLSL

#include "../core/math.glsl"
#include "../microfacet/facets.glsl"

const int LQ_MAX_STRATA = 4;

// How strata are blended.
const int LQ_BLEND_ASYMMETRIC = 0;
const int LQ_BLEND_SYMMETRIC = 1;

// Stands for the logarithm of 0: nothing passes the lowest stratum.
const float LQ_LEAST_LOG = -1.0e4;

// `weight` of the surface's area, in (0, 1]. `eta + i kappa`: index of a conductor's facets over
// that of the medium above them.
struct LqStratum {
    LqFacets facets;
    float weight;
    vec3 eta;
    vec3 kappa;
};

// A stratum in its place: C of its `low` and `high` end, and the logarithms of low / high and of
// (1 - high) / (1 - low), of which powers are the light that passes it upwards and downwards.
struct LqPlacedStratum {
    LqFacets facets;
    float low;
    float high;
    float log_up;
    float log_down;
    vec3 eta;
    vec3 kappa;
};

// `count` strata from the top down, in [1, LQ_MAX_STRATA]; those beyond are not read.
struct LqStrata {
    int blend;
    int count;
    LqPlacedStratum first;
    LqPlacedStratum second;
    LqPlacedStratum third;
    LqPlacedStratum fourth;
};

LqPlacedStratum lq_stratum_at(const LqStrata strata, const int n) {
    if (n == 1) {
        return strata.second;
    }
    if (n == 2) {
        return strata.third;
    }
    if (n == 3) {
        return strata.fourth;
    }
    return strata.first;
}

// log(x) for x in [0, 1], to 5e-7 above 2e-4. The root brings x to where lq_log_ratio serves.
float lq_log_share(const float x) {
    const float eighth_root = sqrt(sqrt(sqrt(x)));
    return x > 0.0 ? 8.0 * lq_log_ratio(max(eighth_root, 0.333333333333333)) : LQ_LEAST_LOG;
}

// Between `low` and `high`, 0 <= low < high <= 1.
LqPlacedStratum lq_stratum_between(const LqStratum stratum, const float low, const float high) {
    return LqPlacedStratum(
        lq_facets_prepare(stratum.facets.ndf, stratum.facets.alpha_x, stratum.facets.alpha_y), low,
        high, lq_log_share(low / high), lq_log_share((1.0 - high) / (1.0 - low)),
        clamp(stratum.eta, vec3(0.0), vec3(LQ_MAX_CONDUCTOR_INDEX)),
        clamp(stratum.kappa, vec3(0.0), vec3(LQ_MAX_CONDUCTOR_INDEX)));
}

// The same surface seen from below, where C is 1 - C.
LqPlacedStratum lq_stratum_turned_over(const LqPlacedStratum stratum) {
    return LqPlacedStratum(stratum.facets, 1.0 - stratum.high, 1.0 - stratum.low, stratum.log_down,
                           stratum.log_up, stratum.eta, stratum.kappa);
}

LqStrata lq_strata_turned_over(const LqStrata strata) {
    const int last = strata.count - 1;
    return LqStrata(strata.blend, strata.count,
                    lq_stratum_turned_over(lq_stratum_at(strata, last)),
                    lq_stratum_turned_over(lq_stratum_at(strata, max(last - 1, 0))),
                    lq_stratum_turned_over(lq_stratum_at(strata, max(last - 2, 0))),
                    lq_stratum_turned_over(strata.first));
}

// cos_theta Lambda(w) of a symmetric blend, whose strata are everywhere in proportion. Eq. 8.
float lq_mixed_projected_lambda(const LqStrata strata, const vec3 w) {
    float sum = 0.0;
    for (int mixed = 0; mixed < strata.count; mixed++) {
        const LqPlacedStratum stratum = lq_stratum_at(strata, mixed);
        sum += (stratum.high - stratum.low) * lq_facets_projected_lambda(stratum.facets, w);
    }
    return sum;
}

#endif
