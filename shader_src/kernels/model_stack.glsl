// Binds the kernels to `lq_stack_*`: the model under the names that every kernel uses, and the rows
// of a packed surface. The host's side is host/backends/pack_stack.cpp.
#ifndef LQ_KERNELS_MODEL_STACK_GLSL
#define LQ_KERNELS_MODEL_STACK_GLSL

#include "stack_rows.glsl"

#include "../stack/stack.glsl"

#define LqModelSurface LqStackSurface
#define lq_model_eval lq_stack_eval
#define lq_model_eval_cos lq_stack_eval_cos
#define lq_model_pdf lq_stack_pdf
#define lq_model_sample lq_stack_sample
#define LqModelView LqStackView
#define lq_model_view lq_stack_view
#define lq_model_view_eval_cos lq_stack_view_eval_cos
#define lq_model_albedo(surface, wo, point_count) lq_stack_albedo(surface, wo)

// Rows: (layer count, base kind, base alpha x, y), (base albedo or eta, base ndf), (base kappa, 0);
// then for each of LQ_MAX_LAYERS (alpha x, y, index, ndf), (absorption, g) and (scattering, 0).
#define LQ_MODEL_ROWS 27u

// The prepared surface whose rows begin at `first`.
LqStackSurface lq_stack_unpack(const uint first) {
    const vec4 head = lq_packed_row(first);
    const vec4 colour = lq_packed_row(first + 1u);
    const vec4 kappa = lq_packed_row(first + 2u);
    const vec3 albedo_or_eta = vec3(colour.x, colour.y, colour.z);
    return lq_stack_prepare(LqStackMaterial(int(first) + 3, int(head.x), int(head.y),
                                            albedo_or_eta,
                                            LqFacets(int(colour.w), head.z, head.w), albedo_or_eta,
                                            vec3(kappa.x, kappa.y, kappa.z)));
}

#define lq_model_unpack lq_stack_unpack

#endif
