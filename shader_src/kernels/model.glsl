// The model that a kernel or the viewer runs, chosen when the variant is compiled.
#ifdef LQ_MODEL_COATED
#include "model_coated.glsl"
#endif
#ifdef LQ_MODEL_STACK
#include "model_stack.glsl"
#endif
#ifdef LQ_MODEL_STACK_SYMMETRIC
#include "model_stack_symmetric.glsl"
#endif
#ifdef LQ_MODEL_MICROSURFACE_SINGLE
#include "model_microsurface_single.glsl"
#endif
#ifdef LQ_MODEL_MICROSURFACE_COMPENSATED
#include "model_microsurface_compensated.glsl"
#endif
#ifdef LQ_MODEL_PLAIN
#include "model_plain.glsl"
#endif
#ifdef LQ_MODEL_CLEARCOAT
#include "model_clearcoat.glsl"
#endif
#ifdef LQ_MODEL_WEIDLICH_WILKIE
#include "model_weidlich_wilkie.glsl"
#endif
#ifdef LQ_MODEL_OPENPBR_COAT
#include "model_openpbr_coat.glsl"
#endif

// What a model can find out about a viewer before it knows the lights. Most know nothing.
#ifndef LqModelView
#define LqModelView vec3
#define lq_model_view(surface, wo) (wo)
#define lq_model_view_eval_cos(surface, view, wi) lq_model_eval_cos(surface, wi, view)
#endif
