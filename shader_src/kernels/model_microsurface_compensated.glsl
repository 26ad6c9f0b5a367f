// Binds the kernels to `lq_microsurface_compensated_*`: the model under the names that every kernel
// uses.
#ifndef LQ_KERNELS_MODEL_MICROSURFACE_COMPENSATED_GLSL
#define LQ_KERNELS_MODEL_MICROSURFACE_COMPENSATED_GLSL

#include "../microsurface_compensated/microsurface_compensated.glsl"
#include "microsurface_rows.glsl"
#include "several_facets_rows.glsl"

#define LQ_MODEL_ROWS (LQ_MICROSURFACE_ROWS + 1u + 2u * LQ_SEVERAL_FACETS_SIDE_ROWS)

#define LqModelSurface LqMicrosurfaceCompensatedSurface
#define lq_model_eval lq_microsurface_compensated_eval
#define lq_model_eval_cos lq_microsurface_compensated_eval_cos
#define lq_model_pdf lq_microsurface_compensated_pdf
#define lq_model_sample lq_microsurface_compensated_sample
#define lq_model_albedo lq_microsurface_compensated_albedo

#define lq_model_unpack(first) lq_microsurface_compensated_unpack(first)

LqMicrosurfaceCompensatedSurface lq_microsurface_compensated_unpack(const uint first) {
    return lq_microsurface_compensated_prepare(
        lq_microsurface_unpack(first), lq_several_facets_unpack(first + LQ_MICROSURFACE_ROWS));
}

#endif
