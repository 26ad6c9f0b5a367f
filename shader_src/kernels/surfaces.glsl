// The surface that a query of a compute kernel shades.
#ifndef LQ_KERNELS_SURFACES_GLSL
#define LQ_KERNELS_SURFACES_GLSL

#include "bindings.glsl"
#include "model.glsl"

LqModelSurface lq_model_surface(const uint query) {
    const uint row = query / parameters.queries_per_surface * LQ_MODEL_ROWS;
    return lq_model_unpack(row);
}

#endif
