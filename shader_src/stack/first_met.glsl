// Which strata of an interface the light of a lobe meets first: each takes part in what the interface
// does by that share, as if all facets met after it were alike.
// Based on: d'Eon et al. 2023, Microfacet Theory for Non-Uniform Heightfields, sections 3.2 and 3.3
#ifndef LQ_STACK_FIRST_MET_GLSL
#define LQ_STACK_FIRST_MET_GLSL

#include "facet_effect.glsl"
#include "layers.glsl"
#include "nodes.glsl"

// 1 + Lambda of isotropic GGX facets at four cosines; nearer to grazing that of LQ_LEAST_COSINE.
vec4 lq_projected_areas_of_four(const float alpha, const vec4 cosines) {
    const vec4 c = max(cosines, vec4(LQ_LEAST_COSINE));
    const float least = max(alpha, LQ_MIN_ALPHA);
    const vec4 tangents = (vec4(1.0) - c) * (vec4(1.0) + c) / (c * c);
    return vec4(0.5) + 0.5 * sqrt(vec4(1.0) + (least * least) * max(tangents, vec4(0.0)));
}

LqNodeValues lq_projected_areas(const float alpha, const LqStackNodes nodes) {
    return LqNodeValues(lq_projected_areas_of_four(alpha, nodes.low),
                        lq_projected_areas_of_four(alpha, nodes.high));
}

// The stratum that comes `met`-th on the way, from above or from below.
LqStackStratum lq_stratum_on_the_way(const LqStackInterface at, const int met, const bool is_down) {
    return lq_stack_stratum(at, is_down ? met : at.count - 1 - met);
}

// What of the surface it is. The lowest takes the rest of all others.
float lq_weight_on_the_way(const LqStackInterface at, const int met, const bool is_down) {
    const int lowest = at.count - 1;
    const int n = is_down ? met : lowest - met;
    if (n < lowest) {
        return clamp(lq_stack_stratum(at, n).weight, 0.0, 1.0);
    }
    float rest = 1.0;
    for (int other = 0; other < lowest; other++) {
        rest -= clamp(lq_stack_stratum(at, other).weight, 0.0, 1.0);
    }
    return clamp(rest, 0.0, 1.0);
}

// On the way through the strata of one interface. Asymmetric: `coming` is the light that has met none
// yet, `high` the fraction of the surface that lies ahead. Symmetric: `all_areas` is 1 + Lambda of all
// facets, and every stratum is met in proportion to its own.
struct LqStrataCrossing {
    LqNodeValues coming;
    LqNodeValues all_areas;
    float high;
};

LqStrataCrossing lq_before_strata(const LqStackInterface at, const LqStackNodes nodes) {
    const LqNodeValues ones = LqNodeValues(vec4(1.0), vec4(1.0));
    if (at.blend != LQ_BLEND_SYMMETRIC) {
        return LqStrataCrossing(ones, ones, 1.0);
    }
    vec4 low = vec4(0.0);
    vec4 high = vec4(0.0);
    for (int ahead = 0; ahead < at.count; ahead++) {
        const float weight = lq_weight_on_the_way(at, ahead, true);
        const LqNodeValues areas = lq_projected_areas(lq_stack_stratum(at, ahead).alpha, nodes);
        low += weight * areas.low;
        high += weight * areas.high;
    }
    return LqStrataCrossing(ones, LqNodeValues(low, high), 1.0);
}

// The light that meets this stratum first, and what is left for those behind it.
struct LqFirstMet {
    LqNodeValues here;
    LqStrataCrossing behind;
};

LqFirstMet lq_first_met(const LqStackInterface at, const LqStrataCrossing before,
                        const float alpha, const float weight, const bool is_last,
                        const LqStackNodes nodes) {
    if (at.count == 1) {
        return LqFirstMet(before.coming, before);
    }
    const LqNodeValues areas = lq_projected_areas(alpha, nodes);
    if (at.blend == LQ_BLEND_SYMMETRIC) {
        return LqFirstMet(LqNodeValues(weight * areas.low / before.all_areas.low,
                                       weight * areas.high / before.all_areas.high),
                          before);
    }
    if (is_last) {
        return LqFirstMet(before.coming, before);
    }
    const float low = max(before.high - weight, 0.0);
    const float log_passed = lq_log_share(low / max(before.high, LQ_TINY_SPREAD));
    const vec4 passed_low = before.coming.low * exp(log_passed * areas.low);
    const vec4 passed_high = before.coming.high * exp(log_passed * areas.high);
    return LqFirstMet(LqNodeValues(before.coming.low - passed_low, before.coming.high - passed_high),
                      LqStrataCrossing(LqNodeValues(passed_low, passed_high), before.all_areas, low));
}

#endif
