// The packed rows of a surface with one coat, which all models of such surfaces read. The host's
// side is host/backends/pack_one_coat.cpp.
#ifndef LQ_KERNELS_ONE_COAT_ROWS_GLSL
#define LQ_KERNELS_ONE_COAT_ROWS_GLSL

#include "../one_coat/surface.glsl"

// Rows: (coat alpha x, y, coat eta, coat ndf), (base alpha x, y, base kind, base ndf), albedo, eta,
// kappa, optical depth.
#define LQ_MODEL_ROWS 6u

// The surface whose rows begin at `first`.
LqOneCoat lq_one_coat_unpack(const uint first) {
    const vec4 coat = lq_packed_row(first);
    const vec4 base = lq_packed_row(first + 1u);
    const vec4 albedo = lq_packed_row(first + 2u);
    const vec4 eta = lq_packed_row(first + 3u);
    const vec4 kappa = lq_packed_row(first + 4u);
    const vec4 optical_depth = lq_packed_row(first + 5u);
    return LqOneCoat(LqFacets(int(coat.w), coat.x, coat.y), coat.z,
                     vec3(optical_depth.x, optical_depth.y, optical_depth.z), int(base.z),
                     vec3(albedo.x, albedo.y, albedo.z),
                     LqFacets(int(base.w), base.x, base.y), vec3(eta.x, eta.y, eta.z),
                     vec3(kappa.x, kappa.y, kappa.z));
}

#define lq_model_unpack(first) lq_model_prepare(lq_one_coat_unpack(first))

#endif
