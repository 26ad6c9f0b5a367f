// The model that a kernel or the viewer runs, chosen when the variant is compiled.
#ifdef LQ_MODEL_PLAIN
#include "model_plain.glsl"
#endif
