// Inputs: wi, wo per query. Results: (f, pdf).
#version 450
#extension GL_GOOGLE_include_directive : require
#include "surfaces.glsl"

void main() {
    const uint query = gl_GlobalInvocationID.x;
    if (query >= parameters.query_count) {
        return;
    }
    const LqModelSurface surface = lq_model_surface(query);
    const vec3 wi = lq_input_vector(2u * query);
    const vec3 wo = lq_input_vector(2u * query + 1u);
    results.rows[query] = vec4(lq_model_eval(surface, wi, wo), lq_model_pdf(surface, wi, wo));
}
