// The light that comes back through a stack from a Lambertian base, exact but for the transport of
// the stack: since the base forgets directions and all above it is reciprocal,
//
//   f(wi, wo) = T(wi) T(wo) rho / (pi n^2 (1 - rho R_bar))
//
// with T(w) the light arriving along w that reaches the base for the first time, R_bar the light
// leaving the base diffusely that returns to it, and n the index above the base over the exterior's.
// Based on: de Dinechin and Belcour 2022, Rendering Layered Materials with Diffuse Interfaces, Eq. 3
#ifndef LQ_STACK_DIFFUSE_BASE_GLSL
#define LQ_STACK_DIFFUSE_BASE_GLSL

#include "transport.glsl"

// Directions of equal weight that average T over the hemisphere.
const int LQ_ARRIVING_DIRECTIONS = 12;

// The share of light at cos_theta that the top interface lets in.
float lq_stack_entering(const LqStackSurface surface, const float cos_theta) {
    const vec4 cosines = vec4(cos_theta);
    if (surface.interfaces[0].x < LQ_MIN_ALPHA) {
        return 1.0 - lq_fresnel_of_four(cosines, surface.top_eta).x;
    }
    return lq_entering(surface.top_above, surface.top_below, surface.top_critical, cosines).x;
}

// T of the three channels, and in w without absorption; cos_theta in [0, 1].
vec4 lq_stack_arriving(const LqStackSurface surface, const float cos_theta) {
    const LqCubic polynomial = surface.arriving;
    const vec4 share = ((polynomial.third * cos_theta + polynomial.second) * cos_theta +
                        polynomial.first) * cos_theta + polynomial.zeroth;
    return lq_stack_entering(surface, cos_theta) * clamp(share, vec4(0.0), vec4(1.0));
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

// T of light at four directions, once it has entered, and in `returning` R_bar without the clear
// part's error.
struct LqDiffuseTransport {
    LqCubic arriving;
    vec4 returning;
};

LqDiffuseTransport lq_diffuse_transport(const LqStackSurface surface) {
    const vec4 cosines =
        vec4(0.0380602337443566, 0.308658283817455, 0.691341716182545, 0.961939766255643);
    vec4 a = vec4(0.0);
    vec4 b = vec4(0.0);
    vec4 c = vec4(0.0);
    vec4 d = vec4(0.0);
    vec4 returning = vec4(0.0);
    // No constant, or compilers would write the transport out so many times.
    const int runs = surface.base == LQ_STACK_BASE_LAMBERTIAN ? 5 : 0;
    for (int run = 0; run < runs; run++) {
        const float lower = run == 0 ? cosines.x : cosines.y;
        const float upper = run == 2 ? cosines.z : cosines.w;
        const int kind = run < 4 ? LQ_LIGHT_ENTERED : LQ_LIGHT_FROM_BELOW;
        const LqStackLight light = lq_stack_light(surface, kind, run < 2 ? lower : upper);
        returning = light.returning;
        if (run < 4) {
            a = b;
            b = c;
            c = d;
            d = light.arrived;
        }
    }
    return LqDiffuseTransport(lq_cubic_through(a, b, c, d), returning);
}

// T averaged over the hemisphere, weighted by the cosine.
vec4 lq_stack_mean_arriving(const LqStackSurface surface) {
    vec4 entering = vec4(0.0);
    const int directions = surface.base == LQ_STACK_BASE_LAMBERTIAN ? LQ_ARRIVING_DIRECTIONS : 0;
    for (int n = 0; n < directions; n++) {
        const float u = (float(n) + 0.5) / float(LQ_ARRIVING_DIRECTIONS);
        entering += lq_stack_arriving(surface, sqrt(u)) / float(LQ_ARRIVING_DIRECTIONS);
    }
    return entering;
}

#endif
