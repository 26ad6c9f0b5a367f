// The packed rows of a surface with one coat, which all models of such surfaces read. The host's
// side is host/backends/pack_one_coat.cpp.
#ifndef LQ_KERNELS_ONE_COAT_ROWS_GLSL
#define LQ_KERNELS_ONE_COAT_ROWS_GLSL

#include "../one_coat/surface.glsl"

// Rows: (coat alpha x, y, coat eta, coat ndf), (base alpha x, y, base kind, base ndf), albedo, eta,
// kappa, optical depth.
#define LQ_MODEL_ROWS 6u

// The surface that six packed rows describe.
LqOneCoat lq_one_coat_unpack(const vec4 coat, const vec4 base, const vec4 albedo, const vec4 eta,
                             const vec4 kappa, const vec4 optical_depth) {
    return LqOneCoat(LqFacets(int(coat.w), coat.x, coat.y), coat.z,
                     vec3(optical_depth.x, optical_depth.y, optical_depth.z), int(base.z),
                     vec3(albedo.x, albedo.y, albedo.z),
                     LqFacets(int(base.w), base.x, base.y), vec3(eta.x, eta.y, eta.z),
                     vec3(kappa.x, kappa.y, kappa.z));
}

// The prepared surface whose rows begin at `rows[first]`. A macro, because the kernels read a
// storage buffer and the viewer a uniform block, and neither can be passed to a function.
#define lq_model_unpack(rows, first)                                                             \
    lq_model_prepare(lq_one_coat_unpack(rows[first], rows[(first) + 1u], rows[(first) + 2u],     \
                                        rows[(first) + 3u], rows[(first) + 4u],                  \
                                        rows[(first) + 5u]))

#endif
