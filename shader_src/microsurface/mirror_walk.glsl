// Walks over rough mirror facets: what conductors reflect, all orders of scattering, and the lobe
// of the first facet alone, as single-scattering models keep it. GGX facets.
// Based on: Heitz et al. 2016, Multiple-Scattering Microfacet BSDFs with the Smith Model
#ifndef LQ_MICROSURFACE_MIRROR_WALK_GLSL
#define LQ_MICROSURFACE_MIRROR_WALK_GLSL

#include "../fresnel/conductor.glsl"
#include "split_ray.glsl"

// A mirror's rest that carries less ends by chance (Russian roulette), which keeps the mean.
const float LQ_FAINT_MIRROR_REST = 0.02;

// Light of the lobe that mirrors reflect after one facet, and how much of that a smooth interface
// would transmit.
struct LqLobeLight {
    float reflected;
    float transmitted;
};

// Fractions of light arriving at cos_theta in [0, 1] that facets of alpha in [0, 1] reflect, for
// three conductors of relative indices eta + i kappa; the mean over walks is what counts.
vec3 lq_walk_conductors(const float cos_theta, const float alpha, const vec3 eta, const vec3 kappa,
                        const LqWalkStream stream) {
    const float rough = clamp(alpha, 0.0, 1.0);
    LqSplitRay ray = lq_split_ray_arriving(cos_theta);
    vec3 kept = vec3(1.0, 1.0, 1.0);
    vec3 reflected = vec3(0.0, 0.0, 0.0);
    for (int facet = 0; facet < LQ_MAX_WALK_FACETS; ++facet) {
        const vec4 u = lq_walk_uniforms(stream, uint(facet));
        ray.depth = lq_split_ray_facet_depth(ray, rough, u.x);
        const vec3 wm = lq_ggx_sample_visible_normal(-ray.w, rough, rough, vec2(u.y, u.z));
        const float cos_theta_i = clamp(-dot(ray.w, wm), 0.0, 1.0);
        kept = kept * lq_fresnel_conductor_rgb(cos_theta_i, eta, kappa);
        ray.w = ray.w + (2.0 * cos_theta_i) * wm;
        const float leaving = lq_split_ray_escape(ray, rough);
        reflected += leaving * kept;
        const float rest = ray.light - leaving;
        if (rest <= LQ_FAINT_MIRROR_REST * u.w) {
            break;
        }
        ray.light = max(rest, LQ_FAINT_MIRROR_REST);
    }
    return reflected;
}

// One direction of the lobe of light arriving at cos_theta in [0, 1]; the interface is of eta in
// [1/3, 3]. Averaged over heights, the chance to leave is G2 / G1.
LqLobeLight lq_walk_mirror_lobe(const float cos_theta, const float alpha, const float eta,
                                const LqWalkStream stream) {
    const float rough = clamp(alpha, 0.0, 1.0);
    const vec3 w = lq_split_ray_arriving(cos_theta).w;
    const vec4 u = lq_walk_uniforms(stream, 0u);
    const vec3 wm = lq_ggx_sample_visible_normal(-w, rough, rough, vec2(u.x, u.y));
    const vec3 out_w = w + (2.0 * clamp(-dot(w, wm), 0.0, 1.0)) * wm;
    if (out_w.z <= 0.0) {
        return LqLobeLight(0.0, 0.0);
    }
    const float masking = lq_walk_opacity(w, rough, rough);
    const float leaving = masking / (masking + lq_walk_opacity(out_w, rough, rough));
    const float ratio = clamp(eta, LQ_MIN_ETA, LQ_MAX_ETA);
    return LqLobeLight(leaving, leaving * (1.0 - lq_fresnel_dielectric(out_w.z, ratio)));
}

#endif
