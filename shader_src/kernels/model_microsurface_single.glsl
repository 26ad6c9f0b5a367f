// Binds the kernels to `lq_microsurface_single_*`: the model under the names that every kernel uses.
#ifndef LQ_KERNELS_MODEL_MICROSURFACE_SINGLE_GLSL
#define LQ_KERNELS_MODEL_MICROSURFACE_SINGLE_GLSL

#include "../microsurface_single/microsurface_single.glsl"
#include "microsurface_rows.glsl"

#define LQ_MODEL_ROWS LQ_MICROSURFACE_ROWS

#define LqModelSurface LqMicrosurfaceSurface
#define lq_model_eval lq_microsurface_single_eval
#define lq_model_eval_cos lq_microsurface_single_eval_cos
#define lq_model_pdf lq_microsurface_single_pdf
#define lq_model_sample lq_microsurface_single_sample
#define lq_model_albedo lq_microsurface_single_albedo

#define lq_model_unpack(first) lq_microsurface_prepare(lq_microsurface_unpack(first))

#endif
