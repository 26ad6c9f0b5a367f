// Scalar helpers, and replacements for built-in functions whose precision varies between drivers.
// No acos, asin, sin, cos or tanh is used anywhere in the library: drivers differ in them by up to
// 4e-4, a hundred times the difference that the library tolerates between languages.
#ifndef LQ_CORE_MATH_GLSL
#define LQ_CORE_MATH_GLSL

#include "constants.glsl"

float lq_square(const float x) {
    return x * x;
}

// Square root that treats a negative argument, which only rounding can produce, as 0.
float lq_safe_sqrt(const float x) {
    return sqrt(max(x, 0.0));
}

float lq_average(const vec3 v) {
    return (v.x + v.y + v.z) * 0.333333333333333;
}

// sqrt(1 - x^2) without the cancellation of x near 1; x in [-1, 1].
float lq_sine_from_cosine(const float x) {
    return lq_safe_sqrt((1.0 - x) * (1.0 + x));
}

// (cos(2 pi turn), sin(2 pi turn)) for turn in [0, 1], to 2e-7.
// The turn is folded to within an eighth of an axis, where short Taylor series converge; folding is
// exact in binary, so that the error does not grow with the angle.
vec2 lq_cos_sin_turn(const float turn) {
    const float quarter = floor(4.0 * turn + 0.5);
    const float angle = (turn - 0.25 * quarter) * (2.0 * LQ_PI);
    const float s = angle * angle;
    const float cosine =
        1.0 + s * (-0.5 + s * (0.0416666666666667 + s * (-0.00138888888888889 +
              s * (2.48015873015873e-05 - s * 2.75573192239859e-07))));
    const float sine =
        angle * (1.0 + s * (-0.166666666666667 + s * (0.00833333333333333 +
                 s * (-0.000198412698412698 + s * 2.75573192239859e-06))));
    if (quarter == 1.0) {
        return vec2(-sine, cosine);
    }
    if (quarter == 2.0) {
        return vec2(-cosine, -sine);
    }
    if (quarter == 3.0) {
        return vec2(sine, -cosine);
    }
    return vec2(cosine, sine);
}

// 2 artanh z for |z| <= 1/2, by its Taylor series, to a few roundings.
float lq_twice_artanh(const float z) {
    const float s = z * z;
    float sum = 0.032258064516129;
    sum = sum * s + 0.0344827586206897;
    sum = sum * s + 0.037037037037037;
    sum = sum * s + 0.04;
    sum = sum * s + 0.0434782608695652;
    sum = sum * s + 0.0476190476190476;
    sum = sum * s + 0.0526315789473684;
    sum = sum * s + 0.0588235294117647;
    sum = sum * s + 0.0666666666666667;
    sum = sum * s + 0.0769230769230769;
    sum = sum * s + 0.0909090909090909;
    sum = sum * s + 0.111111111111111;
    sum = sum * s + 0.142857142857143;
    sum = sum * s + 0.2;
    sum = sum * s + 0.333333333333333;
    sum = sum * s + 1.0;
    return 2.0 * z * sum;
}

// Natural logarithm of x in [1/3, 3], to a few roundings: that of some drivers is off by 1e-6.
float lq_log_ratio(const float x) {
    return lq_twice_artanh((x - 1.0) / (x + 1.0));
}

// log(1 - y) for y in [0, 2/3], with all its digits near 0.
float lq_log_complement(const float y) {
    return lq_twice_artanh(-y / (2.0 - y));
}

// exp(x^2) times the first repeated integral of erfc, for x >= 0, to 3e-7 relative:
//     exp(x^2) ierfc(x) = 1 / sqrt(pi) - x exp(x^2) erfc(x).
// Polynomial in t = 1 / (1 + 0.4 x) by Chebyshev fit, t^2 carrying the decay 1 / (2 sqrt(pi) x^2).
// Written out it is 1 - 1 at large x; this form never subtracts what it is about to lose.
float lq_scaled_ierfc(const float x) {
    const float t = 1.0 / (1.0 + 0.4 * x);
    float sum = -0.0391180249;
    sum = sum * t + 0.253589899;
    sum = sum * t - 0.574588772;
    sum = sum * t + 0.497988661;
    sum = sum * t - 0.146896117;
    sum = sum * t + 0.185267376;
    sum = sum * t + 0.127200639;
    sum = sum * t + 0.125364483;
    sum = sum * t + 0.0902462164;
    sum = sum * t + 0.0451352874;
    return sum * t * t;
}

#endif
