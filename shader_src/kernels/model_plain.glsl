// Binds the kernels to `lq_plain_*`: the model under the names that every kernel uses.
#ifndef LQ_KERNELS_MODEL_PLAIN_GLSL
#define LQ_KERNELS_MODEL_PLAIN_GLSL

#include "../plain/plain.glsl"
#include "one_coat_rows.glsl"

#define LqModelSurface LqOneCoat
#define lq_model_prepare lq_plain_prepare
#define lq_model_eval lq_plain_eval
#define lq_model_eval_cos lq_plain_eval_cos
#define lq_model_pdf lq_plain_pdf
#define lq_model_sample lq_plain_sample
#define lq_model_albedo lq_plain_albedo

#endif
