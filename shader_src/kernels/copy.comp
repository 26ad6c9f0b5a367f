// Moves the bytes of `eval` and computes nothing: what a benchmark measures against.
// Inputs: two rows per query. Results: one.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "bindings.glsl"

void main() {
    const uint query = gl_GlobalInvocationID.x;
    if (query >= parameters.query_count) {
        return;
    }
    results.rows[query] = inputs.rows[2u * query] + inputs.rows[2u * query + 1u];
}
