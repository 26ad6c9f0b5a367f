// Single reflections of a top interface of several strata, and the polynomials of direction that stand
// for sums over them.
// Based on: d'Eon et al. 2023, Microfacet Theory for Non-Uniform Heightfields
#ifndef LQ_STACK_TOP_GLSL
#define LQ_STACK_TOP_GLSL

#include "../interface/energies.glsl"
#include "../microsurface/rough_surface.glsl"
#include "first_met.glsl"
#include "surface.glsl"

LqStratum lq_stack_top_stratum(const LqStackInterface at, const int n) {
    const vec4 row = lq_stack_row(at.row + min(n, at.count - 1));
    return LqStratum(LqFacets(int(row.w), row.x, row.y), row.z, vec3(0.0), vec3(0.0));
}

// The interface as single scattering takes it.
LqRoughSide lq_stack_top_side(const LqStackSurface surface) {
    const LqStackInterface at = lq_stack_interface(surface.first_row, 0);
    return lq_microsurface_prepare(LqMicrosurfaceMaterial(
        at.blend, at.count, at.eta, vec3(0.0), lq_stack_top_stratum(at, 0),
        lq_stack_top_stratum(at, 1), lq_stack_top_stratum(at, 2), lq_stack_top_stratum(at, 3))).above;
}

// The part of an interface's albedo that has met more than one facet.
LqDirectionPolynomial lq_stack_multiple(const float alpha, const float eta) {
    const LqCell cell =
        lq_table_cell(lq_alpha_segment(alpha, LQ_TABLE_ALPHAS), lq_eta_segment(eta, LQ_TABLE_ETAS),
                      LQ_TABLE_ETAS, 1);
    return lq_interface_multiple_function(cell, eta);
}

// Zeros of T_8: four, and the other four mirror them.
vec4 lq_chebyshev_nodes() {
    return vec4(0.980785280403230, 0.831469612302545, 0.555570233019602, 0.195090322016128);
}

// The directions of these zeros to one side of the critical angle (interface/polynomial.glsl).
LqStackNodes lq_stack_fit_nodes(const float critical, const bool above) {
    const vec4 x = lq_chebyshev_nodes();
    const float side = above ? 1.0 : -1.0;
    const vec4 t = vec4(0.5) + 0.5 * side * x;
    const vec4 s = vec4(0.5) - 0.5 * side * x;
    LqStackNodes nodes = LqStackNodes(t * t, s * s, vec4(0.0), vec4(0.0));
    if (above) {
        nodes.low = vec4(critical) + (1.0 - critical) * nodes.low;
        nodes.high = vec4(critical) + (1.0 - critical) * nodes.high;
    } else {
        nodes.low = critical * (vec4(1.0) - nodes.low);
        nodes.high = critical * (vec4(1.0) - nodes.high);
    }
    return nodes;
}

// The coefficients of the polynomial through values at these nodes.
LqOctet lq_octet_through(const LqNodeValues values) {
    const vec4 x = lq_chebyshev_nodes();
    const vec4 even = 0.25 * (values.low + values.high);
    const vec4 odd = 0.25 * (values.low - values.high);
    const vec4 second = 2.0 * x * x - vec4(1.0);
    const vec4 third = x * (2.0 * second - vec4(1.0));
    const vec4 fourth = 2.0 * second * second - vec4(1.0);
    return LqOctet(vec4(0.5 * dot(even, vec4(1.0)), dot(odd, x), dot(even, second),
                        dot(odd, third)),
                   vec4(dot(even, fourth), dot(odd, 2.0 * second * third - x),
                        dot(even, 2.0 * third * third - vec4(1.0)),
                        dot(odd, 2.0 * third * fourth - x)));
}

// To one side of the critical angle: what an interface of several strata lets in, and m.
struct LqStackTopSide {
    LqOctet entering;
    LqOctet multiple;
};

LqStackTopSide lq_stack_blended_side(const LqStackInterface at, const bool above) {
    const float critical = lq_critical_cosine(at.eta);
    const LqStackNodes nodes = lq_stack_fit_nodes(critical, above);
    LqStrataCrossing crossing = lq_before_strata(at, nodes);
    LqNodeValues entering = LqNodeValues(vec4(0.0), vec4(0.0));
    LqNodeValues several = LqNodeValues(vec4(0.0), vec4(0.0));
    for (int met = 0; met < at.count; met++) {
        const LqStackStratum stratum = lq_stack_stratum(at, met);
        const LqFirstMet first =
            lq_first_met(at, crossing, stratum.alpha, lq_weight_on_the_way(at, met, true),
                         met + 1 == at.count, nodes);
        crossing = first.behind;
        const LqNodeValues through = lq_stack_transmittance(stratum.alpha, at.eta, nodes);
        entering.low += first.here.low * through.low;
        entering.high += first.here.high * through.high;
        const LqDirectionPolynomial multiple = lq_stack_multiple(stratum.alpha, at.eta);
        LqOctet here = LqOctet(multiple.above_low, multiple.above_high);
        if (!above) {
            here = LqOctet(multiple.below_low, multiple.below_high);
        }
        several.low += first.here.low * lq_stack_side(here, critical, above, nodes.low);
        several.high += first.here.high * lq_stack_side(here, critical, above, nodes.high);
    }
    return LqStackTopSide(lq_octet_through(entering), lq_octet_through(several));
}

// Of the roughest stratum.
float lq_greatest_alpha(const LqStackInterface at) {
    float greatest = 0.0;
    for (int n = 0; n < at.count; n++) {
        greatest = max(greatest, lq_stack_stratum(at, n).alpha);
    }
    return greatest;
}

#endif
