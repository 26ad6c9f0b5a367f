// Runs every construct.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "../plain/constructs.glsl"
#include "bindings.glsl"

void main() {
    const uint query = gl_GlobalInvocationID.x;
    if (query >= parameters.query_count) {
        return;
    }
    results.rows[query] = vec4(lq_test_all(inputs.rows[query].x), vec3(0.0));
}
