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

// Of four functions at once, one in each component, to one side.
struct LqCoefficients {
    vec4 values[LQ_COEFFICIENTS];
};

struct LqDirectionPolynomial {
    float critical;
    LqCoefficients below;  // not read for eta >= 1
    LqCoefficients above;
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

// The functions at cos_theta in [0, 1], by Clenshaw's recurrence.
vec4 lq_direction_polynomial(const LqDirectionPolynomial polynomial, const float cos_theta) {
    const LqDirectionPlace place = lq_direction_place(cos_theta, polynomial.critical);
    vec4 next = vec4(0.0);
    vec4 after = vec4(0.0);
    for (int n = LQ_COEFFICIENTS - 1; n > 0; n--) {
        const vec4 coefficient = place.is_below ? polynomial.below.values[n] : polynomial.above.values[n];
        const vec4 current = coefficient + next * (2.0 * place.x) - after;
        after = next;
        next = current;
    }
    const vec4 constant = place.is_below ? polynomial.below.values[0] : polynomial.above.values[0];
    return constant + next * place.x - after;
}

// J(n, j) = integral over t in [0, 1] of T_n(2 t - 1) 2 t^(2 j + 1) dt, for j = 0 to 3.
vec4 lq_chebyshev_moments(const int n) {
    if (n == 0) {
        return vec4(1.0, 0.5, 0.333333333333333, 0.25);
    }
    if (n == 1) {
        return vec4(0.333333333333333, 0.3, 0.238095238095238, 0.194444444444444);
    }
    if (n == 2) {
        return vec4(-0.333333333333333, -0.0333333333333333, 0.0476190476190476,
                    0.0722222222222222);
    }
    if (n == 3) {
        return vec4(-0.2, -0.157142857142857, -0.0793650793650794, -0.0318181818181818);
    }
    if (n == 4) {
        return vec4(-0.0666666666666667, -0.10952380952381, -0.0984126984126984,
                    -0.0732323232323232);
    }
    if (n == 5) {
        return vec4(-0.0476190476190476, -0.0555555555555556, -0.0678210678210678,
                    -0.0666278166278166);
    }
    if (n == 6) {
        return vec4(-0.0285714285714286, -0.0333333333333333, -0.0401154401154401,
                    -0.0457042957042957);
    }
    return vec4(-0.0222222222222222, -0.0232323232323232, -0.0256410256410256, -0.0293317793317793);
}

// Integrals of the functions against cos dcos over [0, 1].
vec4 lq_direction_energy(const LqDirectionPolynomial polynomial) {
    const float c = polynomial.critical;
    const float rest = 1.0 - c;
    vec4 sum = vec4(0.0);
    float sign_below = c * c;  // T_n(-x) = (-1)^n T_n(x)
    for (int n = 0; n < LQ_COEFFICIENTS; n++) {
        const vec4 j = lq_chebyshev_moments(n);
        sum += polynomial.below.values[n] * (sign_below * (j.x - j.y)) +
               polynomial.above.values[n] * (rest * (c * j.x + rest * j.y));
        sign_below = -sign_below;
    }
    return sum;
}

// The same against cos^3 dcos.
vec4 lq_direction_spread(const LqDirectionPolynomial polynomial) {
    const float c = polynomial.critical;
    const float rest = 1.0 - c;
    const vec4 binomial = vec4(c * c * c, 3.0 * c * c * rest, 3.0 * c * rest * rest,
                               rest * rest * rest);
    vec4 sum = vec4(0.0);
    float sign_below = c * c * c * c;
    for (int n = 0; n < LQ_COEFFICIENTS; n++) {
        const vec4 j = lq_chebyshev_moments(n);
        sum += polynomial.below.values[n] * (sign_below * (j.x - 3.0 * j.y + 3.0 * j.z - j.w)) +
               polynomial.above.values[n] * (rest * dot(binomial, j));
        sign_below = -sign_below;
    }
    return sum;
}

#endif
