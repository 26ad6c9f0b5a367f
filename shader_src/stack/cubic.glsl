// Cubic polynomials of a cosine from some cosine on to 1, through values at four of them.
#ifndef LQ_STACK_CUBIC_GLSL
#define LQ_STACK_CUBIC_GLSL

// Zeros of T_4(2 x - 1).
const vec4 LQ_CUBIC_NODES =
    vec4(0.0380602337443566, 0.308658283817455, 0.691341716182545, 0.961939766255643);

// The cosine at one of the nodes, 0 to 3 in rising order, of cubics from `least` on.
float lq_cubic_node(const int n, const float least) {
    const float narrow = n == 0 ? LQ_CUBIC_NODES.x : LQ_CUBIC_NODES.y;
    const float wide = n == 2 ? LQ_CUBIC_NODES.z : LQ_CUBIC_NODES.w;
    return mix(least, 1.0, n < 2 ? narrow : wide);
}

// Coefficients of powers of x, a colour channel in each component; x in [0, 1] is how far cos_theta
// has come on the way from `least`, in [0, 1), to 1.
struct LqCubic {
    vec4 zeroth;
    vec4 first;
    vec4 second;
    vec4 third;
    float least;
};

// Below `least` all is as there.
vec4 lq_cubic_value(const LqCubic cubic, const float cos_theta) {
    const float x = max(cos_theta - cubic.least, 0.0) / (1.0 - cubic.least);
    return ((cubic.third * x + cubic.second) * x + cubic.first) * x + cubic.zeroth;
}

// The polynomial of x through values at the zeros of T_4(2 x - 1), in rising order. By its
// Chebyshev coefficients, which are a discrete cosine transform.
LqCubic lq_cubic_through(const vec4 a, const vec4 b, const vec4 c, const vec4 d,
                         const float least) {
    const float wide = 0.923879532511287;   // cos(pi / 8)
    const float narrow = 0.38268343236509;  // cos(3 pi / 8)
    const vec4 outer = d - a;
    const vec4 inner = c - b;
    const vec4 zeroth = 0.25 * (a + b + c + d);
    const vec4 first = 0.5 * (wide * outer + narrow * inner);
    const vec4 second = 0.353553390593274 * (a + d - b - c);
    const vec4 third = 0.5 * (narrow * outer - wide * inner);
    return LqCubic(zeroth - first + second - third, 2.0 * first - 8.0 * second + 18.0 * third,
                   8.0 * second - 48.0 * third, 32.0 * third, least);
}

#endif
