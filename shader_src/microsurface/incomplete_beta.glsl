// The incomplete beta function, as much of it as lies between two heights of a rough surface.
// Based on: Press et al. 2007, Numerical Recipes, section 6.4 (its continued fraction)
#ifndef LQ_MICROSURFACE_INCOMPLETE_BETA_GLSL
#define LQ_MICROSURFACE_INCOMPLETE_BETA_GLSL

#include "../core/math.glsl"

// Of the fraction: terms that Lambdas up to 200 take, eight of which are enough for 20.
const int LQ_BETA_TERMS = 20;
const float LQ_BETA_PRECISION = 1.0e-6;
const float LQ_LEAST_BETA_TERM = 1.0e-30;

// Lambdas beyond are as this one.
const float LQ_MAX_BETA_LAMBDA = 1.0e8;

// Of a Lambda above this the fraction on the peak's far side has few digits left: where the range has
// both sides, that one gets a smaller part of the integral, the other so much more of it.
const float LQ_LARGE_BETA_LAMBDA = 200.0;
const float LQ_BETA_LEAN = 4.0;

// base^exponent for base in [0, 1], `complement` being 1 - base: near 1, where large exponents make
// the last digits count.
float lq_share_power(const float base, const float complement, const float exponent) {
    if (exponent <= 0.0) {
        return 1.0;
    }
    if (complement > 0.5) {
        return pow(max(base, 0.0), exponent);
    }
    return exp(exponent * lq_log_complement(max(complement, 0.0)));
}

float lq_away_from_zero(const float x) {
    return abs(x) < LQ_LEAST_BETA_TERM ? LQ_LEAST_BETA_TERM : x;
}

// The integral over t from 0 to x of t^(a - 1) (1 - t)^(b - 1), times a / (x^a (1 - x)^b); for x up to
// the peak (a + 1) / (a + b + 2), where it converges fast. By Lentz's method.
float lq_beta_fraction(const float x, const float a, const float b) {
    float c = 1.0;
    float d = 1.0 / lq_away_from_zero(1.0 - (a + b) * x / (a + 1.0));
    float h = d;
    float change = 0.0;
    for (int term = 1; term <= LQ_BETA_TERMS; term++) {
        if (abs(change - 1.0) > LQ_BETA_PRECISION) {
            const float m = float(term);
            const float even = m * (b - m) * x / ((a - 1.0 + 2.0 * m) * (a + 2.0 * m));
            d = 1.0 / lq_away_from_zero(1.0 + even * d);
            c = lq_away_from_zero(1.0 + even / c);
            h *= d * c;
            const float odd = -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 1.0 + 2.0 * m));
            d = 1.0 / lq_away_from_zero(1.0 + odd * d);
            c = lq_away_from_zero(1.0 + odd / c);
            change = d * c;
            h *= change;
        }
    }
    return h;
}

// A range of heights C, from `low` to `high`, and what both leave to 1.
struct LqHeights {
    float low;
    float above_low;
    float high;
    float above_high;
};

// The integral over c from 0 to x of (c / high)^lambda ((1 - c) / above_low)^other, x within the
// range and up to the peak; `above` is 1 - x.
float lq_beta_up_to(const float x, const float above, const LqHeights range, const float lambda,
                    const float other) {
    if (x <= 0.0) {
        return 0.0;
    }
    return lq_share_power(x / range.high, (above - range.above_high) / range.high, lambda) *
           lq_share_power(above / range.above_low, (x - range.low) / range.above_low, other) * x *
           above / (1.0 + lambda) * lq_beta_fraction(x, 1.0 + lambda, 1.0 + other);
}

// The part of lq_beta_between up to `peak`; `past_peak` is 1 - peak.
float lq_beta_below_peak(const LqHeights range, const float peak, const float past_peak,
                         const float lambda, const float other) {
    if (range.low >= peak) {
        return 0.0;
    }
    const bool ends = range.high < peak;
    return lq_beta_up_to(ends ? range.high : peak, ends ? range.above_high : past_peak, range,
                         lambda, other) -
           lq_beta_up_to(range.low, range.above_low, range, lambda, other);
}

// The integral over c from `low` to `high` of
//     (c / high)^lambda_up ((1 - c) / (1 - low))^lambda_down,
// 0 <= low < high <= 1, both lambdas in [0, LQ_MAX_BETA_LAMBDA], to 1e-5 relative while one is below
// 20: light that facets between both heights see above and below, as far as it leaves this range of
// heights. Each side of the peak is taken from its own end.
float lq_beta_between(const float low, const float high, const float lambda_up,
                      const float lambda_down) {
    const float sum = 4.0 + lambda_up + lambda_down;
    const bool leans_up = lambda_up > LQ_LARGE_BETA_LAMBDA && (1.0 - high) * sum < 2.0 + lambda_down;
    const bool leans_down = lambda_down > LQ_LARGE_BETA_LAMBDA && low * sum < 2.0 + lambda_up;
    const float up = 2.0 + lambda_up + (leans_down ? LQ_BETA_LEAN : 0.0);
    const float down = 2.0 + lambda_down + (leans_up ? LQ_BETA_LEAN : 0.0);
    const float peak = up / (up + down);
    const float past_peak = down / (up + down);
    const LqHeights range = LqHeights(low, 1.0 - low, high, 1.0 - high);
    const LqHeights flipped = LqHeights(range.above_high, high, range.above_low, low);
    return max(lq_beta_below_peak(range, peak, past_peak, lambda_up, lambda_down) +
                   lq_beta_below_peak(flipped, past_peak, peak, lambda_down, lambda_up),
               0.0);
}

#endif
