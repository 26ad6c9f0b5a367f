// The model that a kernel runs, chosen when the variant is compiled.
#ifdef LQ_MODEL_PLAIN
#include "model_plain.glsl"
#endif
