// Binds the kernels to `lq_plain_*`: the model under the names that every kernel uses, and the rows
// of a packed surface. The host's side is host/backends/pack_plain.cpp.
#ifndef LQ_KERNELS_MODEL_PLAIN_GLSL
#define LQ_KERNELS_MODEL_PLAIN_GLSL

#include "../plain/plain.glsl"

#define LqModelSurface LqPlainSurface
#define lq_model_eval lq_plain_eval
#define lq_model_eval_cos lq_plain_eval_cos
#define lq_model_pdf lq_plain_pdf
#define lq_model_sample lq_plain_sample
#define lq_model_albedo lq_plain_albedo

// Rows: (coat alpha x, y, coat eta, coat ndf), (base alpha x, y, base kind, base ndf), albedo, eta,
// kappa.
#define LQ_MODEL_ROWS 5u

// The prepared surface that five packed rows describe.
LqPlainSurface lq_plain_unpack(const vec4 coat, const vec4 base, const vec4 albedo, const vec4 eta,
                               const vec4 kappa) {
    return lq_plain_prepare(LqPlainSurface(
        LqFacets(int(coat.w), coat.x, coat.y), coat.z, int(base.z),
        vec3(albedo.x, albedo.y, albedo.z), LqFacets(int(base.w), base.x, base.y),
        vec3(eta.x, eta.y, eta.z), vec3(kappa.x, kappa.y, kappa.z)));
}

// The surface whose rows begin at `rows[first]`. A macro, because the kernels read a storage buffer
// and the viewer a uniform block, and neither can be passed to a function.
#define lq_model_unpack(rows, first)                                                             \
    lq_plain_unpack(rows[first], rows[(first) + 1u], rows[(first) + 2u], rows[(first) + 3u],     \
                    rows[(first) + 4u])

#endif
