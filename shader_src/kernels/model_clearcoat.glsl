// Binds the kernels to `lq_clearcoat_*`: the model under the names that every kernel uses.
#ifndef LQ_KERNELS_MODEL_CLEARCOAT_GLSL
#define LQ_KERNELS_MODEL_CLEARCOAT_GLSL

#include "../clearcoat/clearcoat.glsl"
#include "one_coat_rows.glsl"

#define LqModelSurface LqOneCoat
#define lq_model_prepare lq_clearcoat_prepare
#define lq_model_eval lq_clearcoat_eval
#define lq_model_eval_cos lq_clearcoat_eval_cos
#define lq_model_pdf lq_clearcoat_pdf
#define lq_model_sample lq_clearcoat_sample
#define lq_model_albedo lq_clearcoat_albedo

#endif
