// A shading point under many lights: prepared once, then parameters.point_count lights from the
// directions of the queries that follow, around to the first. For measuring what each part costs.
// Inputs: a direction per query, its viewer's. Results: (sum of f cos_theta_i, 1).
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surfaces.glsl"

void main() {
    const uint query = gl_GlobalInvocationID.x;
    if (query >= parameters.query_count) {
        return;
    }
    const LqModelSurface surface = lq_model_surface(query);
    const LqModelView viewer = lq_model_view(surface, lq_input_vector(query));
    vec3 sum = vec3(0.0);
    uint light = query;
    for (uint n = 0u; n < parameters.point_count; n++) {
        light = light + 1u < parameters.query_count ? light + 1u : 0u;
        sum += lq_model_view_eval_cos(surface, viewer, lq_input_vector(light));
    }
    results.rows[query] = vec4(sum, 1.0);
}
