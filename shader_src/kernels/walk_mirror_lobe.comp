// The lobe of rough mirrors after one facet: parameters.point_count walks.
// Inputs: as in walk_queries.glsl.
// Results: sums of (light reflected, of that transmitted by a smooth interface of eta, 0, 0).
#version 450
#extension GL_GOOGLE_include_directive : require
#include "walk_queries.glsl"
#include "../microsurface/mirror_walk.glsl"

void main() {
    const uint query = gl_GlobalInvocationID.x;
    if (query >= parameters.query_count) {
        return;
    }
    const vec4 facets = inputs.rows[2u * query];
    float reflected = 0.0;
    float transmitted = 0.0;
    for (uint n = 0u; n < parameters.point_count; ++n) {
        const LqLobeLight light = lq_walk_mirror_lobe(facets.z, facets.x, facets.y,
                                                      lq_walk_stream(2u * query, n));
        reflected += light.reflected;
        transmitted += light.transmitted;
    }
    results.rows[query] = vec4(reflected, transmitted, 0.0, 0.0);
}
