// Light above the facets of a Smith half space, for walks that count what escapes instead of
// leaving that to chance. GGX facets.
#ifndef LQ_MICROSURFACE_SPLIT_RAY_GLSL
#define LQ_MICROSURFACE_SPLIT_RAY_GLSL

#include "walk.glsl"

// Keeps the flight of a ray along the normal of smooth facets, which meets nothing, finite.
const float LQ_MIN_WALK_OPACITY = 1.0e-30;

// Which random numbers a walk draws: two words of a seed, and the walk's own number.
struct LqWalkStream {
    uint seed_low;
    uint seed_high;
    uint walk;
};

// Light travelling along `w` (unit; upwards it may leave) at a depth of the half space, see
// walk.glsl. `below` tells which side of the interface the half space belongs to.
struct LqSplitRay {
    vec3 w;
    float depth;
    float light;
    bool below;
};

// Four uniform numbers in [0, 1).
vec4 lq_walk_uniforms(const LqWalkStream stream, const uint draw) {
    return lq_random_uniforms(uvec4(stream.seed_low, stream.walk, stream.seed_high, draw));
}

// Light 1 from above, towards -x; cos_theta is clamped to [0, 1].
LqSplitRay lq_split_ray_arriving(const float cos_theta) {
    const float cosine = clamp(cos_theta, LQ_MIN_WALK_COSINE, 1.0);
    return LqSplitRay(vec3(-lq_sine_from_cosine(cosine), 0.0, -cosine), 0.0, 1.0, false);
}

// The part of the ray's light that meets no further facet.
float lq_split_ray_escape(const LqSplitRay ray, const float alpha) {
    return ray.w.z > 0.0 ? ray.light * exp(-lq_walk_opacity(ray.w, alpha, alpha) * ray.depth) : 0.0;
}

// Depth of the facet that the ray meets next, given that it meets one; u in [0, 1).
float lq_split_ray_facet_depth(const LqSplitRay ray, const float alpha, const float u) {
    const float opacity = max(lq_walk_opacity(ray.w, alpha, alpha), LQ_MIN_WALK_OPACITY);
    if (ray.w.z < 0.0) {
        return ray.depth - log(1.0 - u) / opacity;
    }
    const float meeting = 1.0 - exp(-opacity * ray.depth);
    return clamp(ray.depth + log(1.0 - u * meeting) / opacity, 0.0, ray.depth);
}

#endif
