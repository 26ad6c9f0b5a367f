// Binds the kernels to `lq_stack_symmetric_*`: the model under the names that every kernel uses.
#ifndef LQ_KERNELS_MODEL_STACK_SYMMETRIC_GLSL
#define LQ_KERNELS_MODEL_STACK_SYMMETRIC_GLSL

#include "stack_rows.glsl"

#include "../stack_symmetric/stack_symmetric.glsl"
#include "stack_material.glsl"

#define LqModelSurface LqStackSymmetricSurface
#define lq_model_eval lq_stack_symmetric_eval
#define lq_model_eval_cos lq_stack_symmetric_eval_cos
#define lq_model_pdf lq_stack_symmetric_pdf
#define lq_model_sample lq_stack_symmetric_sample
#define LqModelView LqStackSymmetricView
#define lq_model_view lq_stack_symmetric_view
#define lq_model_view_eval_cos lq_stack_symmetric_view_eval_cos
#define lq_model_albedo(surface, wo, point_count) lq_stack_symmetric_albedo(surface, wo)

#define lq_model_unpack(first) lq_stack_symmetric_prepare(lq_stack_unpack(first))

#endif
