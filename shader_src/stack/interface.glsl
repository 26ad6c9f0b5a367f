// The shares of light that cross a rough interface, all orders of scattering: polynomials of
// direction, to both sides of the critical angle.
#ifndef LQ_STACK_INTERFACE_GLSL
#define LQ_STACK_INTERFACE_GLSL

#include "../interface/polynomial.glsl"
#include "../tables/interpolate.glsl"
#include "facet_effect.glsl"
#include "nodes.glsl"

// Sums of Chebyshev polynomials T_0 to T_7 at four places x at once.
vec4 lq_chebyshev_sums(const vec4 low, const vec4 high, const vec4 x) {
    const vec4 second = 2.0 * x * x - vec4(1.0);
    const vec4 third = x * (2.0 * second - vec4(1.0));
    const vec4 fourth = 2.0 * second * second - vec4(1.0);
    return vec4(low.x) + low.y * x + low.z * second + low.w * third +
           (high.x * fourth + high.y * (2.0 * second * third - x) +
            high.z * (2.0 * third * third - vec4(1.0)) + high.w * (2.0 * third * fourth - x));
}

// The coefficients of an interface's transmittance `above` its critical angle, or below it, where
// into a denser medium nothing is.
LqOctet lq_stack_transmittance_octet(const float alpha, const float eta, const bool above) {
    const bool is_thin = eta < 1.0;
    const int columns = is_thin ? LQ_T_DOWN_THIN_ETAS : LQ_TABLE_ETAS;
    const float within = is_thin ? min(eta, 1.0 - LQ_ETA_NEAR_ONE) : eta;
    const LqCell cell = lq_table_cell(lq_alpha_segment(alpha, LQ_TABLE_ALPHAS),
                                      lq_eta_segment(within, columns), columns, 1);
    const int thin = above ? LQ_CLEAR_THIN_ABOVE : LQ_CLEAR_THIN_BELOW;
    return lq_table_read(cell, is_thin ? thin : LQ_CLEAR_DENSE_ABOVE);
}

// The polynomial at four cosines of one side of the critical angle; 0 at those of the other.
vec4 lq_stack_side(const LqOctet octet, const float critical, const bool above,
                   const vec4 cosines) {
    const float side = above ? 1.0 : -1.0;
    const float width = above ? 1.0 - critical : max(critical, LQ_TINY_SPREAD);
    const vec4 share = max(side * (cosines - vec4(critical)), vec4(0.0)) / width;
    const vec4 is_above = step(vec4(critical), cosines);
    return lq_chebyshev_sums(octet.low, octet.high, side * (2.0 * sqrt(share) - vec4(1.0))) *
           (above ? is_above : vec4(1.0) - is_above);
}

// Into a medium of index `eta` over this one's, of light in the directions of a lobe. The loop runs
// as often as there are sides.
LqNodeValues lq_stack_transmittance(const float alpha, const float eta, const LqStackNodes nodes) {
    const bool is_smooth = alpha < LQ_MIN_ALPHA;
    const float critical = lq_critical_cosine(eta);
    const int rough_sides = eta < 1.0 ? 2 : 1;
    const int sides = is_smooth ? 0 : rough_sides;
    LqNodeValues rough = LqNodeValues(vec4(0.0), vec4(0.0));
    for (int side = 0; side < sides; side++) {
        const bool above = side == 0;
        const LqOctet octet = lq_stack_transmittance_octet(alpha, eta, above);
        rough.low += lq_stack_side(octet, critical, above, nodes.low);
        rough.high += lq_stack_side(octet, critical, above, nodes.high);
    }
    if (is_smooth) {
        return LqNodeValues(vec4(1.0) - lq_fresnel_of_four(nodes.low, eta),
                            vec4(1.0) - lq_fresnel_of_four(nodes.high, eta));
    }
    return LqNodeValues(clamp(rough.low, vec4(0.0), vec4(1.0)),
                        clamp(rough.high, vec4(0.0), vec4(1.0)));
}

#endif
