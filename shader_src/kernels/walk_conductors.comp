// Light reflected by rough conductors, three at once: parameters.point_count walks.
// Inputs: as in walk_queries.glsl (eta is not read), then three etas and three kappas.
// Results: (sums of the fractions reflected, 0).
#version 450
#extension GL_GOOGLE_include_directive : require
#include "walk_queries.glsl"
#include "../microsurface/mirror_walk.glsl"

void main() {
    const uint query = gl_GlobalInvocationID.x;
    if (query >= parameters.query_count) {
        return;
    }
    const vec4 facets = inputs.rows[4u * query];
    const vec3 eta = lq_input_vector(4u * query + 2u);
    const vec3 kappa = lq_input_vector(4u * query + 3u);
    vec3 sum = vec3(0.0, 0.0, 0.0);
    for (uint n = 0u; n < parameters.point_count; ++n) {
        sum += lq_walk_conductors(facets.z, facets.x, eta, kappa, lq_walk_stream(4u * query, n));
    }
    results.rows[query] = vec4(sum, 0.0);
}
