// Functions of direction at an interface as polynomials: evaluated without reading a table, and
// integrated in closed form.
//
// cos_theta = c + (1 - c) t^2 above the critical cosine c of light that enters, and c (1 - t^2) below
// it, t in [0, 1]: near c the Fresnel equations follow its square root, and so does t. To each side
// the function is a sum of Chebyshev polynomials T_n(x): x = 2 t - 1 above, x = 1 - 2 t below. For
// eta >= 1 there is no critical angle, c is 0, and all directions are above.
#ifndef LQ_INTERFACE_POLYNOMIAL_GLSL
#define LQ_INTERFACE_POLYNOMIAL_GLSL

#include "../core/math.glsl"

const int LQ_COEFFICIENTS = 8;  // to each side

// Coefficients, to one side, of four functions at once: one in each component.
struct LqCoefficients {
    vec4 values[LQ_COEFFICIENTS];
};

// Four functions of direction.
struct LqDirectionPolynomials {
    LqCoefficients below;  // not read for eta >= 1
    LqCoefficients above;
};

// One function: the coefficients of T_0 to T_3, and of T_4 to T_7.
struct LqDirectionPolynomial {
    vec4 below_low;
    vec4 below_high;
    vec4 above_low;
    vec4 above_high;
};

// T_0 to T_3, and T_4 to T_7.
struct LqChebyshev {
    vec4 low;
    vec4 high;
};

// Cosine of the critical angle of light that enters; 0 for eta >= 1.
float lq_critical_cosine(const float eta) {
    return lq_safe_sqrt((1.0 - eta) * (1.0 + eta));
}

// Which side of the critical angle a direction is on, and its x there.
struct LqDirectionPlace {
    bool is_below;
    float x;
};

LqDirectionPlace lq_direction_place(const float cos_theta, const float critical) {
    if (cos_theta < critical) {
        return LqDirectionPlace(true,
                                1.0 - 2.0 * lq_safe_sqrt((critical - cos_theta) / critical));
    }
    return LqDirectionPlace(
        false, 2.0 * lq_safe_sqrt((cos_theta - critical) / (1.0 - critical)) - 1.0);
}

// Each from those of half its degree: fewer steps, and fewer roundings, than one after the other.
LqChebyshev lq_chebyshev(const float x) {
    const float second = 2.0 * x * x - 1.0;
    const float third = x * (2.0 * second - 1.0);
    const float fourth = 2.0 * second * second - 1.0;
    return LqChebyshev(vec4(1.0, x, second, third),
                       vec4(fourth, 2.0 * second * third - x, 2.0 * third * third - 1.0,
                            2.0 * third * fourth - x));
}

vec4 lq_weighted_sum(const LqCoefficients side, const vec4 low, const vec4 high) {
    return side.values[0] * low.x + side.values[1] * low.y + side.values[2] * low.z +
           side.values[3] * low.w +
           (side.values[4] * high.x + side.values[5] * high.y + side.values[6] * high.z +
            side.values[7] * high.w);
}

// Four functions at cos_theta in [0, 1]; `critical` as lq_critical_cosine says.
vec4 lq_direction_values(const LqDirectionPolynomials functions, const float critical,
                         const float cos_theta) {
    const LqDirectionPlace place = lq_direction_place(cos_theta, critical);
    const LqChebyshev t = lq_chebyshev(place.x);
    if (place.is_below) {
        return lq_weighted_sum(functions.below, t.low, t.high);
    }
    return lq_weighted_sum(functions.above, t.low, t.high);
}

// One function.
float lq_direction_value(const LqDirectionPolynomial polynomial, const float critical,
                         const float cos_theta) {
    const LqDirectionPlace place = lq_direction_place(cos_theta, critical);
    const LqChebyshev t = lq_chebyshev(place.x);
    if (place.is_below) {
        return dot(polynomial.below_low, t.low) + dot(polynomial.below_high, t.high);
    }
    return dot(polynomial.above_low, t.low) + dot(polynomial.above_high, t.high);
}

// Weights of coefficients in an integral over directions.
struct LqDirectionWeights {
    vec4 below_low;
    vec4 below_high;
    vec4 above_low;
    vec4 above_high;
};

// `moments.x` to `moments.w` times the integrals of T_n(2 t - 1) 2 t dt, times those of
// T_n(2 t - 1) 2 t^3 dt, t^5 and t^7, over t in [0, 1]: for n = 0 to 3, and for n = 4 to 7.
vec4 lq_chebyshev_moments_low(const vec4 moments) {
    return vec4(1.0, 0.333333333333333, -0.333333333333333, -0.2) * moments.x +
           vec4(0.5, 0.3, -0.0333333333333333, -0.157142857142857) * moments.y +
           vec4(0.333333333333333, 0.238095238095238, 0.0476190476190476, -0.0793650793650794) *
               moments.z +
           vec4(0.25, 0.194444444444444, 0.0722222222222222, -0.0318181818181818) * moments.w;
}

vec4 lq_chebyshev_moments_high(const vec4 moments) {
    return vec4(-0.0666666666666667, -0.0476190476190476, -0.0285714285714286, -0.0222222222222222) *
               moments.x +
           vec4(-0.10952380952381, -0.0555555555555556, -0.0333333333333333, -0.0232323232323232) *
               moments.y +
           vec4(-0.0984126984126984, -0.0678210678210678, -0.0401154401154401, -0.0256410256410256) *
               moments.z +
           vec4(-0.0732323232323232, -0.0666278166278166, -0.0457042957042957, -0.0293317793317793) *
               moments.w;
}

// From what an integrand is below and above the critical angle: 2 t dt times a polynomial of t^2.
LqDirectionWeights lq_direction_weights(const vec4 below, const vec4 above) {
    const vec4 mirror = vec4(1.0, -1.0, 1.0, -1.0);  // T_n(-x) = (-1)^n T_n(x)
    return LqDirectionWeights(mirror * lq_chebyshev_moments_low(below),
                              mirror * lq_chebyshev_moments_high(below),
                              lq_chebyshev_moments_low(above), lq_chebyshev_moments_high(above));
}

// Of cos_theta dcos_theta.
LqDirectionWeights lq_energy_weights(const float critical) {
    const float below = critical * critical;
    const float rest = 1.0 - critical;
    return lq_direction_weights(vec4(below, -below, 0.0, 0.0),
                                vec4(rest * critical, rest * rest, 0.0, 0.0));
}

// Half of sin^2_theta at the critical angle: the mean of sin^2_theta over what it encloses.
float lq_mean_sine_squared(const float critical) {
    return 0.5 * (1.0 - critical) * (1.0 + critical);
}

// Of (sin^2_theta - lq_mean_sine_squared) cos_theta dcos_theta. Functions that hardly vary within
// the critical angle have integrals near 0, with little rounding.
LqDirectionWeights lq_spread_weights(const float critical) {
    const float below = critical * critical;
    const float rest = 1.0 - critical;
    const float mean = lq_mean_sine_squared(critical);
    return lq_direction_weights(
        below * vec4(mean, 2.0 * below - mean, -3.0 * below, below),
        rest * vec4(critical * mean, rest * (mean - 2.0 * below), -3.0 * critical * rest * rest,
                    -rest * rest * rest));
}

// Integrals of four functions.
vec4 lq_direction_integrals(const LqDirectionPolynomials functions, const LqDirectionWeights w) {
    return lq_weighted_sum(functions.below, w.below_low, w.below_high) +
           lq_weighted_sum(functions.above, w.above_low, w.above_high);
}

// The integral of one function.
float lq_direction_integral(const LqDirectionPolynomial polynomial, const LqDirectionWeights w) {
    return dot(polynomial.below_low, w.below_low) + dot(polynomial.below_high, w.below_high) +
           dot(polynomial.above_low, w.above_low) + dot(polynomial.above_high, w.above_high);
}

#endif
