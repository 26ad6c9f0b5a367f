// Binds the kernels to `lq_stack_*`: the model under the names that every kernel uses.
#ifndef LQ_KERNELS_MODEL_STACK_GLSL
#define LQ_KERNELS_MODEL_STACK_GLSL

#include "stack_rows.glsl"

#include "../stack/stack.glsl"
#include "stack_material.glsl"

#define LqModelSurface LqStackSurface
#define lq_model_eval lq_stack_eval
#define lq_model_eval_cos lq_stack_eval_cos
#define lq_model_pdf lq_stack_pdf
#define lq_model_sample lq_stack_sample
#define LqModelView LqStackView
#define lq_model_view lq_stack_view
#define lq_model_view_eval_cos lq_stack_view_eval_cos
#define lq_model_albedo(surface, wo, point_count) lq_stack_albedo(surface, wo)

#define lq_model_unpack(first) lq_stack_prepare(lq_stack_unpack(first))

#endif
