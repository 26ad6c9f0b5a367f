// The first two input rows of every kernel that bakes tables: (alpha, eta, cos_theta, first walk),
// (seed_low, seed_high, 0, 0). Walks and seeds are whole numbers below 2^24, which floats hold.
#ifndef LQ_KERNELS_WALK_QUERIES_GLSL
#define LQ_KERNELS_WALK_QUERIES_GLSL

#include "../microsurface/split_ray.glsl"
#include "bindings.glsl"

uint lq_whole_number(const float x) {
    return uint(clamp(x, 0.0, 16777215.0));
}

// The stream of walk `n` of the query whose inputs begin at `row`.
LqWalkStream lq_walk_stream(const uint row, const uint n) {
    const vec4 seed = inputs.rows[row + 1u];
    return LqWalkStream(lq_whole_number(seed.x), lq_whole_number(seed.y),
                        lq_whole_number(inputs.rows[row].w) + n);
}

#endif
