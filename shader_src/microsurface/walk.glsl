// Walks of light through one rough dielectric interface, all orders of scattering: the energies
// that the tables hold, on a GPU. GGX facets, isotropic or not.
// Based on: Heitz et al. 2016, Multiple-Scattering Microfacet BSDFs with the Smith Model
//
// The surface is a half space. Depth is -log of the fraction of the surface below a height, so that
// the opacity to a direction per unit of depth is the same at every depth.
#ifndef LQ_MICROSURFACE_WALK_GLSL
#define LQ_MICROSURFACE_WALK_GLSL

#include "../core/random.glsl"
#include "../core/sampling.glsl"
#include "../fresnel/dielectric.glsl"
#include "../microfacet/ggx.glsl"

// Facets that one walk may meet; the few that met more are lost.
const int LQ_MAX_WALK_FACETS = 1024;

// Walks of one call; its sums are floats, which count to 2^24 exactly.
const int LQ_MAX_WALKS = 65536;

// Cosine of a ray along the surface, whose opacity would be infinite.
const float LQ_MIN_WALK_COSINE = 1.0e-6;

// Depth of a facet at the very top, which is infinitely deep from the other side.
const float LQ_MIN_WALK_DEPTH = 1.0e-30;

// Below it 1 - exp(-depth) is summed as a series, which keeps its digits.
const float LQ_SHALLOW_DEPTH = 0.1;

// Above it -log(1 - exp(-depth)) is the first terms of its series, for the same reason.
const float LQ_GREAT_DEPTH = 8.0;

// What each random number is for: the third word of its counter.
const uint LQ_WALK_ENTERING = 0u;
const uint LQ_WALK_LEAVING = 1u;
const uint LQ_WALK_START = 2u;

// How a walk left the interface. `direction` is where it travels; not `escaped` when it met too
// many facets.
struct LqCrossing {
    vec3 direction;
    bool below;
    bool escaped;
};

// Sums over walks. `energies` are (T, R) of light arriving from above and (R, T) of diffuse light
// from below, each with its crossings of the medium below; `squares` sums their squares.
// `spread` sums c r^2, (c r^2)^2 and c^2 r^2 over the light that leaves above, c what it carries
// and r^2 the square of its direction's length on the disk; its last component is 0.
struct LqInterfaceSums {
    vec4 energies;
    vec4 squares;
    vec4 spread;
};

// Opacity to a ray along w: Smith's Lambda upwards, and 1 + Lambda(-w) downwards.
float lq_walk_opacity(const vec3 w, const float alpha_x, const float alpha_y) {
    const float cosine = max(abs(w.z), LQ_MIN_WALK_COSINE);
    const float lambda =
        lq_ggx_projected_lambda(vec3(w.x, w.y, cosine), alpha_x, alpha_y) / cosine;
    return w.z < 0.0 ? 1.0 + lambda : lambda;
}

// The same height measured from the other side of the surface: -log(1 - exp(-depth)).
float lq_walk_turned_depth(const float depth) {
    if (depth > LQ_GREAT_DEPTH) {
        const float rest = exp(-depth);
        return rest * (1.0 + 0.5 * rest);
    }
    if (depth > LQ_SHALLOW_DEPTH) {
        return -log(1.0 - exp(-depth));
    }
    const float x = max(depth, LQ_MIN_WALK_DEPTH);
    return -log(x * (1.0 - x * (0.5 - x * (0.166666666666667 - x * 0.0416666666666667))));
}

// Direction of a ray along w refracted by a facet of normal wm (dot(w, wm) < 0) below the critical
// angle; eta is the ratio of the index behind the facet to that before it.
vec3 lq_walk_refracted(const vec3 w, const vec3 wm, const float cos_theta_i, const float eta) {
    const float cos2_theta_t = 1.0 - (1.0 - cos_theta_i * cos_theta_i) / (eta * eta);
    return normalize(w / eta + wm * (cos_theta_i / eta - lq_safe_sqrt(cos2_theta_t)));
}

// Walks a ray that travels along `direction` (unit; downwards from above, upwards from below)
// through the interface. `counter` gives the stream, the walk and the purpose of its random
// numbers; its last component counts facets.
LqCrossing lq_walk_interface(const vec3 direction, const float eta, const float alpha_x,
                             const float alpha_y, const uvec4 counter) {
    bool below = direction.z > 0.0;
    // In the frame of its side a ray arrives downwards and leaves upwards.
    vec3 w = vec3(direction.x, direction.y, -max(abs(direction.z), LQ_MIN_WALK_COSINE));
    float depth = 0.0;
    bool escaped = false;
    for (int facet = 0; facet < LQ_MAX_WALK_FACETS; ++facet) {
        const vec4 u = lq_random_uniforms(uvec4(counter.x, counter.y, counter.z, uint(facet)));
        const float opacity = lq_walk_opacity(w, alpha_x, alpha_y);
        const float thickness = -log(1.0 - u.x);
        if (w.z >= 0.0) {
            if (thickness >= opacity * depth) {
                escaped = true;
                break;
            }
            depth = max(depth - thickness / opacity, 0.0);
        } else {
            depth += thickness / opacity;
        }
        const vec3 wm = lq_ggx_sample_visible_normal(-w, alpha_x, alpha_y, vec2(u.y, u.z));
        const float cos_theta_i = clamp(-dot(w, wm), 0.0, 1.0);
        const float eta_behind = below ? 1.0 / eta : eta;
        if (u.w < lq_fresnel_dielectric(cos_theta_i, eta_behind)) {
            w = w + (2.0 * cos_theta_i) * wm;
        } else {
            const vec3 refracted = lq_walk_refracted(w, wm, cos_theta_i, eta_behind);
            w = vec3(refracted.x, refracted.y, -refracted.z);
            depth = lq_walk_turned_depth(depth);
            below = !below;
        }
    }
    return LqCrossing(vec3(w.x, w.y, below ? -w.z : w.z), below, escaped);
}

// Share of light that crosses a medium of normal transmittance tau in [0, 1] at cos_theta.
float lq_walk_transmittance(const float tau, const float cos_theta) {
    if (tau <= 0.0 || tau >= 1.0) {
        return tau <= 0.0 ? 0.0 : 1.0;
    }
    return exp(log(tau) / max(abs(cos_theta), LQ_MIN_WALK_COSINE));
}

// `walk_count` walks (at most LQ_MAX_WALKS) of light that arrives from above at cos_theta, towards
// -x, and as many of diffuse light from below. eta in [1/3, 3], alpha, tau and cos_theta in [0, 1];
// what is outside is clamped. Different streams draw independent numbers.
LqInterfaceSums lq_walk_interface_sums(const float alpha, const float eta, const float tau,
                                       const float cos_theta, const uint stream,
                                       const int walk_count) {
    const float rough = clamp(alpha, 0.0, 1.0);
    const float ratio = clamp(eta, LQ_MIN_ETA, LQ_MAX_ETA);
    const float clear = clamp(tau, 0.0, 1.0);
    const float cosine = clamp(cos_theta, 0.0, 1.0);
    const vec3 downwards = vec3(-lq_sine_from_cosine(cosine), 0.0, -cosine);
    vec4 energies = vec4(0.0, 0.0, 0.0, 0.0);
    vec4 squares = vec4(0.0, 0.0, 0.0, 0.0);
    vec4 spread = vec4(0.0, 0.0, 0.0, 0.0);
    const int count = min(walk_count, LQ_MAX_WALKS);
    for (int n = 0; n < count; ++n) {
        const LqCrossing entered = lq_walk_interface(downwards, ratio, rough, rough,
                                                     uvec4(stream, uint(n), LQ_WALK_ENTERING, 0u));
        const vec4 start = lq_random_uniforms(uvec4(stream, uint(n), LQ_WALK_START, 0u));
        const vec3 upwards = lq_sample_cosine_hemisphere(vec2(start.x, start.y));
        const LqCrossing left = lq_walk_interface(upwards, ratio, rough, rough,
                                                  uvec4(stream, uint(n), LQ_WALK_LEAVING, 0u));
        const float down = lq_walk_transmittance(clear, entered.direction.z);
        const float up = lq_walk_transmittance(clear, upwards.z);
        const float back = up * lq_walk_transmittance(clear, left.direction.z);
        const vec4 carried = vec4(entered.escaped && entered.below ? down : 0.0,
                                  entered.escaped && !entered.below ? 1.0 : 0.0,
                                  left.escaped && left.below ? back : 0.0,
                                  left.escaped && !left.below ? up : 0.0);
        const vec3 exit = left.direction;
        const float radius_squared = exit.x * exit.x + exit.y * exit.y;
        const float weighted = carried.w * radius_squared;
        energies += carried;
        squares += carried * carried;
        spread += vec4(weighted, weighted * weighted, carried.w * weighted, 0.0);
    }
    return LqInterfaceSums(energies, squares, spread);
}

#endif
