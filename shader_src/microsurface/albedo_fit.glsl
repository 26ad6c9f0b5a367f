// A function of direction as a polynomial in the root of its cosine, through values at the zeros of
// T_7(2 sqrt(cos_theta) - 1): near grazing, where masking changes fastest, zeros are dense.
#ifndef LQ_MICROSURFACE_ALBEDO_FIT_GLSL
#define LQ_MICROSURFACE_ALBEDO_FIT_GLSL

#include "../core/math.glsl"

const int LQ_ALBEDO_NODES = 7;

// Coefficients of T_0 to T_6, of three quantities at once.
struct LqAlbedoFit {
    vec3 of_zero;
    vec3 of_one;
    vec3 of_two;
    vec3 of_three;
    vec3 of_four;
    vec3 of_five;
    vec3 of_six;
};

LqAlbedoFit lq_albedo_fit_zero() {
    return LqAlbedoFit(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0),
                       vec3(0.0));
}

// The argument of the T_n at a node, n in [0, LQ_ALBEDO_NODES).
float lq_albedo_node(const int n) {
    const int beyond = n > 3 ? 6 - n : n;
    const float sense = n > 3 ? -1.0 : 1.0;
    if (beyond == 0) {
        return sense * 0.974927912181824;
    }
    if (beyond == 1) {
        return sense * 0.78183148246803;
    }
    return beyond == 2 ? sense * 0.433883739117558 : 0.0;
}

float lq_albedo_node_cosine(const int n) {
    return lq_square(0.5 + 0.5 * lq_albedo_node(n));
}

// The fit with the value of one more node; from zero, with all of them, it is through them.
LqAlbedoFit lq_albedo_fit_with(const LqAlbedoFit fit, const int n, const vec3 value) {
    const float x = lq_albedo_node(n);
    const float second = 2.0 * x * x - 1.0;
    const float third = 2.0 * x * second - x;
    const float fourth = 2.0 * x * third - second;
    const float fifth = 2.0 * x * fourth - third;
    const float sixth = 2.0 * x * fifth - fourth;
    const vec3 part = value * 0.142857142857143;
    const vec3 twice = part * 2.0;
    return LqAlbedoFit(fit.of_zero + part, fit.of_one + twice * x, fit.of_two + twice * second,
                       fit.of_three + twice * third, fit.of_four + twice * fourth,
                       fit.of_five + twice * fifth, fit.of_six + twice * sixth);
}

// By Clenshaw's recurrence.
vec3 lq_albedo_fit_at(const LqAlbedoFit fit, const float cos_theta) {
    const float x = 2.0 * lq_safe_sqrt(cos_theta) - 1.0;
    const float twice = 2.0 * x;
    const vec3 fifth = fit.of_five + twice * fit.of_six;
    const vec3 fourth = fit.of_four + twice * fifth - fit.of_six;
    const vec3 third = fit.of_three + twice * fourth - fifth;
    const vec3 second = fit.of_two + twice * third - fourth;
    const vec3 first = fit.of_one + twice * second - third;
    return fit.of_zero + x * first - second;
}

// What a node counts for in an average over cosine-weighted directions: the integral over x from 0
// to 1 of 4 x^3 times its polynomial.
float lq_albedo_node_weight(const int n) {
    const float x = lq_albedo_node(n);
    const float second = 2.0 * x * x - 1.0;
    const float third = 2.0 * x * second - x;
    const float fourth = 2.0 * x * third - second;
    const float fifth = 2.0 * x * fourth - third;
    const float sixth = 2.0 * x * fifth - fourth;
    return (1.0 + 1.2 * x - 0.133333333333333 * second - 0.628571428571429 * third -
            0.438095238095238 * fourth - 0.222222222222222 * fifth - 0.133333333333333 * sixth) *
           0.142857142857143;
}

#endif
