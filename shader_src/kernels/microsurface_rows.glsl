// The rows of a packed rough surface. The host's side is host/backends/pack_microsurface.cpp.
#ifndef LQ_KERNELS_MICROSURFACE_ROWS_GLSL
#define LQ_KERNELS_MICROSURFACE_ROWS_GLSL

#include "../microsurface/rough_surface.glsl"

// Rows: (blend, stratum count, eta, 0), (optical depth, 0); then for each of LQ_MAX_STRATA
// (alpha x, y, weight, ndf), (eta, 0) and (kappa, 0).
#define LQ_MICROSURFACE_ROWS 14u

LqStratum lq_stratum_unpack(const uint first) {
    const vec4 facets = lq_packed_row(first);
    const vec4 eta = lq_packed_row(first + 1u);
    const vec4 kappa = lq_packed_row(first + 2u);
    return LqStratum(LqFacets(int(facets.w), facets.x, facets.y), facets.z,
                     vec3(eta.x, eta.y, eta.z), vec3(kappa.x, kappa.y, kappa.z));
}

// The surface whose rows begin at `first`.
LqMicrosurfaceMaterial lq_microsurface_unpack(const uint first) {
    const vec4 head = lq_packed_row(first);
    const vec4 depth = lq_packed_row(first + 1u);
    return LqMicrosurfaceMaterial(int(head.x), int(head.y), head.z, vec3(depth.x, depth.y, depth.z),
                          lq_stratum_unpack(first + 2u), lq_stratum_unpack(first + 5u),
                          lq_stratum_unpack(first + 8u), lq_stratum_unpack(first + 11u));
}

#endif
