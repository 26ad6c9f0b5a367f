// Inputs: wo per query. Results: (direct, 0), (base, 0), (transmitted, 0).
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surfaces.glsl"

void main() {
    const uint query = gl_GlobalInvocationID.x;
    if (query >= parameters.query_count) {
        return;
    }
    const LqModelSurface surface = lq_model_surface(query);
    const vec3 wo = lq_input_vector(query);
    const LqAlbedo albedo = lq_model_albedo(surface, wo, int(parameters.point_count));
    results.rows[3u * query] = vec4(albedo.direct, 0.0);
    results.rows[3u * query + 1u] = vec4(albedo.base, 0.0);
    results.rows[3u * query + 2u] = vec4(albedo.transmitted, 0.0);
}
