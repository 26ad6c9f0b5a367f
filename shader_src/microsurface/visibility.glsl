// What of each stratum of a surface can be seen from one direction, or from two.
// Based on: d'Eon et al. 2023, Microfacet Theory for Non-Uniform Heightfields, section 3.3
//
// A ray leaves from the height C = c of a stratum with the probability (c / high)^Lambda, and passes
// a stratum above with (low / high)^Lambda. Rays in two directions leave independently, as one would
// of both their Lambdas; of a stratum they see
//     passed above * high (1 - (low / high)^(1 + Lambda)) / (1 + Lambda).
#ifndef LQ_MICROSURFACE_VISIBILITY_GLSL
#define LQ_MICROSURFACE_VISIBILITY_GLSL

#include "strata.glsl"

// 1 - exp(x) for x <= 0, which near 0 would be left with few digits.
float lq_one_minus_exp(const float x) {
    const float small = -x * (1.0 + x * (0.5 + x * (0.166666666666667 + x * (0.0416666666666667 +
                              x * (0.00833333333333333 + x * 0.00138888888888889)))));
    return x > -0.25 ? small : 1.0 - exp(x);
}

// While strata are looked at from the top down: what of the stratum at hand is visible, over
// cos_theta or over both cosines; and of rays from below, what passes all so far.
struct LqVisibility {
    float here;
    float passed;
};

LqVisibility lq_nothing_passed_yet() {
    return LqVisibility(0.0, 1.0);
}

// The next stratum of an asymmetric blend. `cosines` is cos_theta (or the product of both) times
// 1 + Lambda, and `cosine` without.
LqVisibility lq_visibility_below(const LqVisibility above, const LqPlacedStratum stratum,
                                 const float cosines, const float cosine) {
    const float exponent = cosines / max(cosine, LQ_MIN_COSINE_PRODUCT);
    const float hidden = lq_one_minus_exp(stratum.log_up * exponent);
    const float through = exp(stratum.log_up * max(exponent - 1.0, 0.0));
    return LqVisibility(above.passed * stratum.high * hidden / max(cosines, LQ_MIN_COSINE_PRODUCT),
                        above.passed * through);
}

// The next stratum of either blend. `mixed` is what `cosines` are of a symmetric one.
LqVisibility lq_next_visibility(const LqVisibility above, const int blend,
                                const LqPlacedStratum stratum, const float cosines,
                                const float mixed, const float cosine) {
    if (blend == LQ_BLEND_SYMMETRIC) {
        const float share = stratum.high - stratum.low;
        return LqVisibility(share / max(mixed, LQ_MIN_COSINE_PRODUCT), 1.0);
    }
    return lq_visibility_below(above, stratum, cosines, cosine);
}

#endif
