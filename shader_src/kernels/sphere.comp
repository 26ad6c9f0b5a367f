// Radiance towards the viewer of a surface under a directional light of irradiance
// parameters.radiance (across the beam).
// Inputs: wi, wo per pixel in its local frame. Results: (radiance, 1).
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
    const vec3 light = vec3(parameters.radiance.x, parameters.radiance.y, parameters.radiance.z);
    results.rows[query] = vec4(light * lq_model_eval_cos(surface, wi, wo), 1.0);
}
