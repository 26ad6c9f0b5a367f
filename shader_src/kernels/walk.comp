// Walks through one rough dielectric interface: parameters.point_count from each side.
// Inputs: (alpha, eta, tau, cos_theta), (stream, 0, 0, 0) per query, the stream a whole number.
// Results: the energies, their squares and the spread of LqInterfaceSums.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "bindings.glsl"
#include "../microsurface/walk.glsl"

void main() {
    const uint query = gl_GlobalInvocationID.x;
    if (query >= parameters.query_count) {
        return;
    }
    const vec4 boundary = inputs.rows[2u * query];
    const uint stream = uint(inputs.rows[2u * query + 1u].x);
    const LqInterfaceSums sums =
        lq_walk_interface_sums(boundary.x, boundary.y, boundary.z, boundary.w, stream,
                               int(parameters.point_count));
    results.rows[3u * query] = sums.energies;
    results.rows[3u * query + 1u] = sums.squares;
    results.rows[3u * query + 2u] = sums.spread;
}
