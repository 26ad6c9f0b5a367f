// The parameters of a stack's layers, from the packed rows of surfaces.
#ifndef LQ_KERNELS_STACK_ROWS_GLSL
#define LQ_KERNELS_STACK_ROWS_GLSL

vec4 lq_stack_row(const int index) {
    return lq_packed_row(uint(index));
}

#endif
