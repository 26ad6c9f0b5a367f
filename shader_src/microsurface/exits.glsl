// Where the light of one walk leaves a rough dielectric interface: one set of walks gives the
// energies over every medium below. GGX facets, all orders of scattering.
// Based on: Heitz et al. 2016, Multiple-Scattering Microfacet BSDFs with the Smith Model
//
// Unlike `lq_walk_interface`, a walk follows no single path: each facet splits the light in two,
// what escapes is counted, and chance decides only which of the two rests goes on.
#ifndef LQ_MICROSURFACE_EXITS_GLSL
#define LQ_MICROSURFACE_EXITS_GLSL

#include "split_ray.glsl"

// A rest that carries less than this ends by chance (Russian roulette), which keeps the mean.
const float LQ_FAINT_REST = 0.05;

// Light that left to one side: all of it, and the cosine of one of its ways out, drawn in
// proportion to what each carries. The mean of light * f(cosine) is therefore that over all ways.
struct LqExit {
    float light;
    float cosine;
};

// `reflected_once` is the part of the light reflected that met a single facet.
struct LqExits {
    LqExit entered;
    LqExit reflected;
    float reflected_once;
};

// What a facet makes of a ray.
struct LqSplit {
    LqSplitRay mirrored;
    LqSplitRay passed;
};

// `light` of `ray` is added to the exit on its side. u in [0, 1) draws the cosine.
LqExits lq_exits_with(const LqExits exits, const LqSplitRay ray, const float light, const float u) {
    const float known = ray.below ? exits.entered.light : exits.reflected.light;
    const float known_cosine = ray.below ? exits.entered.cosine : exits.reflected.cosine;
    const float sum = known + light;
    const LqExit exit = LqExit(sum, u * sum < light ? min(ray.w.z, 1.0) : known_cosine);
    if (ray.below) {
        return LqExits(exit, exits.reflected, exits.reflected_once);
    }
    return LqExits(exits.entered, exit, exits.reflected_once);
}

// The next facet that the ray meets; u are three numbers in [0, 1). The half space is turned over
// for what passes, so that it is above its facets again.
LqSplit lq_split_at_facet(const LqSplitRay ray, const float alpha, const float eta, const vec3 u) {
    const float depth = lq_split_ray_facet_depth(ray, alpha, u.x);
    const vec3 wm = lq_ggx_sample_visible_normal(-ray.w, alpha, alpha, vec2(u.y, u.z));
    const float cos_theta_i = clamp(-dot(ray.w, wm), 0.0, 1.0);
    const float eta_behind = ray.below ? 1.0 / eta : eta;
    const float reflectance = lq_fresnel_dielectric(cos_theta_i, eta_behind);
    const vec3 refracted = lq_walk_refracted(ray.w, wm, cos_theta_i, eta_behind);
    return LqSplit(LqSplitRay(ray.w + (2.0 * cos_theta_i) * wm, depth, ray.light * reflectance,
                              ray.below),
                   LqSplitRay(vec3(refracted.x, refracted.y, -refracted.z),
                              lq_walk_turned_depth(depth), ray.light * (1.0 - reflectance),
                              !ray.below));
}

// Light arriving from above at cos_theta in [0, 1] on facets of alpha in [0, 1]; eta in [1/3, 3].
// What is outside is clamped. For light from below turn the interface over: 1 / eta.
LqExits lq_walk_exits(const float cos_theta, const float alpha, const float eta,
                      const LqWalkStream stream) {
    const float rough = clamp(alpha, 0.0, 1.0);
    const float ratio = clamp(eta, LQ_MIN_ETA, LQ_MAX_ETA);
    LqSplitRay ray = lq_split_ray_arriving(cos_theta);
    LqExits exits = LqExits(LqExit(0.0, 1.0), LqExit(0.0, 1.0), 0.0);
    for (int facet = 0; facet < LQ_MAX_WALK_FACETS; ++facet) {
        const vec4 u = lq_walk_uniforms(stream, 2u * uint(facet));
        const vec4 v = lq_walk_uniforms(stream, 2u * uint(facet) + 1u);
        const LqSplit split = lq_split_at_facet(ray, rough, ratio, vec3(u.x, u.y, u.z));
        const float mirrored_light = lq_split_ray_escape(split.mirrored, rough);
        const float passed_light = lq_split_ray_escape(split.passed, rough);
        exits = lq_exits_with(exits, split.mirrored, mirrored_light, v.x);
        exits = lq_exits_with(exits, split.passed, passed_light, v.y);
        exits.reflected_once += facet == 0 ? mirrored_light : 0.0;
        const float mirrored_rest = split.mirrored.light - mirrored_light;
        const float rest = mirrored_rest + split.passed.light - passed_light;
        if (rest <= LQ_FAINT_REST * v.z) {
            break;
        }
        if (u.w * rest < mirrored_rest) {
            ray = split.mirrored;
        } else {
            ray = split.passed;
        }
        ray.light = max(rest, LQ_FAINT_REST);
    }
    return exits;
}

#endif
