// Cubic polynomials of a cosine, through values at four of them.
#ifndef LQ_STACK_CUBIC_GLSL
#define LQ_STACK_CUBIC_GLSL

// Zeros of T_4(2 c - 1).
const vec4 LQ_CUBIC_NODES =
    vec4(0.0380602337443566, 0.308658283817455, 0.691341716182545, 0.961939766255643);

// Coefficients of powers of cos_theta, a colour channel in each component.
struct LqCubic {
    vec4 zeroth;
    vec4 first;
    vec4 second;
    vec4 third;
};

vec4 lq_cubic_value(const LqCubic cubic, const float c) {
    return ((cubic.third * c + cubic.second) * c + cubic.first) * c + cubic.zeroth;
}

// The polynomial of c through values at the zeros of T_4(2 c - 1), in rising order. By its
// Chebyshev coefficients, which are a discrete cosine transform.
LqCubic lq_cubic_through(const vec4 a, const vec4 b, const vec4 c, const vec4 d) {
    const float wide = 0.923879532511287;   // cos(pi / 8)
    const float narrow = 0.38268343236509;  // cos(3 pi / 8)
    const vec4 outer = d - a;
    const vec4 inner = c - b;
    const vec4 zeroth = 0.25 * (a + b + c + d);
    const vec4 first = 0.5 * (wide * outer + narrow * inner);
    const vec4 second = 0.353553390593274 * (a + d - b - c);
    const vec4 third = 0.5 * (narrow * outer - wide * inner);
    return LqCubic(zeroth - first + second - third, 2.0 * first - 8.0 * second + 18.0 * third,
                   8.0 * second - 48.0 * third, 32.0 * third);
}

#endif
