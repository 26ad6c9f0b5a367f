// Binds the kernels to `lq_weidlich_wilkie_*`: the model under the names that every kernel uses.
#ifndef LQ_KERNELS_MODEL_WEIDLICH_WILKIE_GLSL
#define LQ_KERNELS_MODEL_WEIDLICH_WILKIE_GLSL

#include "../weidlich_wilkie/weidlich_wilkie.glsl"
#include "one_coat_rows.glsl"

#define LqModelSurface LqOneCoat
#define lq_model_prepare lq_weidlich_wilkie_prepare
#define lq_model_eval lq_weidlich_wilkie_eval
#define lq_model_eval_cos lq_weidlich_wilkie_eval_cos
#define lq_model_pdf lq_weidlich_wilkie_pdf
#define lq_model_sample lq_weidlich_wilkie_sample
#define lq_model_albedo lq_weidlich_wilkie_albedo

#endif
