// Inputs: wo, then three uniform numbers, per query. Results: (wi, pdf), (weight, 0).
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surfaces.glsl"

void main() {
    const uint query = gl_GlobalInvocationID.x;
    if (query >= parameters.query_count) {
        return;
    }
    const LqModelSurface surface = lq_model_surface(query);
    const vec3 wo = lq_input_vector(2u * query);
    const vec3 u = lq_input_vector(2u * query + 1u);
    const LqSample chosen = lq_model_sample(surface, wo, u);
    results.rows[2u * query] = vec4(chosen.wi, chosen.pdf);
    results.rows[2u * query + 1u] = vec4(chosen.weight, 0.0);
}
