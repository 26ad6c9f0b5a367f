// Binds the kernels to `lq_coated_*`: the model under the names that every kernel uses, and the rows
// of a packed surface. The host's side is host/backends/pack_coated.cpp.
#ifndef LQ_KERNELS_MODEL_COATED_GLSL
#define LQ_KERNELS_MODEL_COATED_GLSL

#include "../coated/coated.glsl"

#define LqModelSurface LqCoatedSurface
#define lq_model_eval lq_coated_eval
#define lq_model_eval_cos lq_coated_eval_cos
#define lq_model_pdf lq_coated_pdf
#define lq_model_sample lq_coated_sample
#define LqModelView LqCoatedView
#define lq_model_view lq_coated_view
#define lq_model_view_eval_cos lq_coated_view_eval_cos
#define lq_model_albedo(surface, wo, point_count) lq_coated_albedo(surface, wo)

// Rows: (coat alpha x, y, eta, ndf), (tau, base lobe), (albedo, 0).
#define LQ_MODEL_ROWS 3u

// The prepared surface whose rows begin at `first`.
LqCoatedSurface lq_coated_unpack(const uint first) {
    const vec4 coat = lq_packed_row(first);
    const vec4 tau = lq_packed_row(first + 1u);
    const vec4 albedo = lq_packed_row(first + 2u);
    return lq_coated_prepare(LqCoatedMaterial(
        LqFacets(int(coat.w), coat.x, coat.y), coat.z, vec3(tau.x, tau.y, tau.z),
        vec3(albedo.x, albedo.y, albedo.z), int(tau.w)));
}

#define lq_model_unpack lq_coated_unpack

#endif
