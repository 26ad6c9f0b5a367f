// The rows of a packed stack. The host's side is host/backends/pack_stack.cpp.
#ifndef LQ_KERNELS_STACK_MATERIAL_GLSL
#define LQ_KERNELS_STACK_MATERIAL_GLSL

#include "../stack/material.glsl"

// Rows: (layer count, base kind, base alpha x, y), (base albedo or eta, base ndf), (base kappa, 0);
// then for each of LQ_MAX_LAYERS (alpha x, y, index, ndf), (absorption, g) and (scattering, 0); then
// the strata of interfaces that are blends, up to LQ_MAX_STRATA for each layer.
#define LQ_MODEL_ROWS (3u + 7u * uint(LQ_MAX_LAYERS))

// The stack whose rows begin at `first`.
LqStackMaterial lq_stack_unpack(const uint first) {
    const vec4 head = lq_packed_row(first);
    const vec4 colour = lq_packed_row(first + 1u);
    const vec4 kappa = lq_packed_row(first + 2u);
    const vec3 albedo_or_eta = vec3(colour.x, colour.y, colour.z);
    return LqStackMaterial(int(first) + 3, int(head.x), int(head.y), albedo_or_eta,
                           LqFacets(int(colour.w), head.z, head.w), albedo_or_eta,
                           vec3(kappa.x, kappa.y, kappa.z));
}

#endif
