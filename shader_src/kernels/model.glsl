// The model that a kernel or the viewer runs, chosen when the variant is compiled.
#ifdef LQ_MODEL_COATED
#include "model_coated.glsl"
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
