// What a rough dielectric interface makes of light from above: parameters.point_count walks.
// Inputs: as in walk_queries.glsl.
// Results: sums of (light entered, reflected by one facet, reflected after more than one, 0).
#version 450
#extension GL_GOOGLE_include_directive : require
#include "walk_queries.glsl"
#include "../microsurface/exits.glsl"

void main() {
    const uint query = gl_GlobalInvocationID.x;
    if (query >= parameters.query_count) {
        return;
    }
    const vec4 boundary = inputs.rows[2u * query];
    float entered = 0.0;
    float once = 0.0;
    float again = 0.0;
    for (uint n = 0u; n < parameters.point_count; ++n) {
        const LqExits exits = lq_walk_exits(boundary.z, boundary.x, boundary.y,
                                            lq_walk_stream(2u * query, n));
        entered += exits.entered.light;
        once += exits.reflected_once;
        again += max(exits.reflected.light - exits.reflected_once, 0.0);
    }
    results.rows[query] = vec4(entered, once, again, 0.0);
}
