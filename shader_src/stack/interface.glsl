// The interfaces of a stack, each as four polynomials of direction: contracted from the tables once,
// then directions cost no read.
#ifndef LQ_STACK_INTERFACE_GLSL
#define LQ_STACK_INTERFACE_GLSL

#include "../interface/polynomial.glsl"
#include "../tables/interpolate.glsl"
#include "facet_effect.glsl"

// Rows of coefficients per interface: of T01 at a clear medium, two for light that enters the denser
// medium, and two above and two below the critical angle for light that enters the thinner one.
#define LQ_INTERFACE_ROWS 6

// The coefficients of one interface.
struct LqInterfaceRows {
    LqOctet dense;
    LqOctet thin_above;
    LqOctet thin_below;
};

// `ratio` = larger index over the smaller, in [1, 3].
LqInterfaceRows lq_interface_rows(const float alpha, const float ratio) {
    const LqSegment row = lq_alpha_segment(alpha, LQ_TABLE_ALPHAS);
    const LqCell dense = lq_table_cell(row, lq_eta_segment(ratio, LQ_TABLE_ETAS), LQ_TABLE_ETAS, 1);
    // An index of 1 is on both sides of 1.
    const float reciprocal = min(1.0 / ratio, 1.0 - LQ_ETA_NEAR_ONE);
    const LqCell thin = lq_table_cell(row, lq_eta_segment(reciprocal, LQ_T_DOWN_THIN_ETAS),
                                      LQ_T_DOWN_THIN_ETAS, 1);
    return LqInterfaceRows(lq_table_read(dense, LQ_CLEAR_DENSE_ABOVE),
                           lq_table_read(thin, LQ_CLEAR_THIN_ABOVE),
                           lq_table_read(thin, LQ_CLEAR_THIN_BELOW));
}

// Sums of Chebyshev polynomials T_0 to T_7 at four places x at once.
vec4 lq_chebyshev_sums(const vec4 low, const vec4 high, const vec4 x) {
    const vec4 second = 2.0 * x * x - vec4(1.0);
    const vec4 third = x * (2.0 * second - vec4(1.0));
    const vec4 fourth = 2.0 * second * second - vec4(1.0);
    return vec4(low.x) + low.y * x + low.z * second + low.w * third +
           (high.x * fourth + high.y * (2.0 * second * third - x) +
            high.z * (2.0 * third * third - vec4(1.0)) + high.w * (2.0 * third * fourth - x));
}

// The shares of light at four cosines in [0, 1] that cross an interface of critical cosine
// `critical`, which is 0 into the denser medium.
vec4 lq_entering(const LqOctet above, const LqOctet below, const float critical,
                 const vec4 cosines) {
    const vec4 within = max(cosines - vec4(critical), vec4(0.0)) / (1.0 - critical);
    const vec4 beyond = max(vec4(critical) - cosines, vec4(0.0)) / max(critical, LQ_TINY_SPREAD);
    const vec4 shares = mix(
        lq_chebyshev_sums(above.low, above.high, 2.0 * sqrt(within) - vec4(1.0)),
        lq_chebyshev_sums(below.low, below.high, vec4(1.0) - 2.0 * sqrt(beyond)),
        vec4(1.0) - step(vec4(critical), cosines));
    return clamp(shares, vec4(0.0), vec4(1.0));
}

#endif
