// Eight walks of light from above through a rough dielectric interface: the most whose results fit
// the smallest storage buffers with the other kernels' number of queries.
// Inputs: as in walk_queries.glsl.
// Results: per walk (light entered, cosine, light reflected, cosine).
#version 450
#extension GL_GOOGLE_include_directive : require
#include "walk_queries.glsl"
#include "../microsurface/exits.glsl"

const uint LQ_WALKS_PER_QUERY = 8u;

void main() {
    const uint query = gl_GlobalInvocationID.x;
    if (query >= parameters.query_count) {
        return;
    }
    const vec4 boundary = inputs.rows[2u * query];
    for (uint n = 0u; n < LQ_WALKS_PER_QUERY; ++n) {
        const LqExits exits = lq_walk_exits(boundary.z, boundary.x, boundary.y,
                                            lq_walk_stream(2u * query, n));
        results.rows[LQ_WALKS_PER_QUERY * query + n] =
            vec4(exits.entered.light, exits.entered.cosine, exits.reflected.light,
                 exits.reflected.cosine);
    }
}
