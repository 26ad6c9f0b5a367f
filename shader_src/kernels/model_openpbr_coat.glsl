// Binds the kernels to `lq_openpbr_coat_*`: the model under the names that every kernel uses.
#ifndef LQ_KERNELS_MODEL_OPENPBR_COAT_GLSL
#define LQ_KERNELS_MODEL_OPENPBR_COAT_GLSL

#include "../openpbr_coat/openpbr_coat.glsl"
#include "one_coat_rows.glsl"

#define LqModelSurface LqOpenpbrCoat
#define lq_model_prepare lq_openpbr_coat_prepare
#define lq_model_eval lq_openpbr_coat_eval
#define lq_model_eval_cos lq_openpbr_coat_eval_cos
#define lq_model_pdf lq_openpbr_coat_pdf
#define lq_model_sample lq_openpbr_coat_sample
#define lq_model_albedo lq_openpbr_coat_albedo

#endif
