// The baked tables for the picture of a sphere, from a texture: not every language has storage
// buffers in fragment shaders.
#ifndef LQ_VIEWER_TABLES_GLSL
#define LQ_VIEWER_TABLES_GLSL

#include "../tables/texels.glsl"

// Of all levels, these read tables.
#if defined(LQ_MODEL_COATED) || defined(LQ_MODEL_STACK) || defined(LQ_MODEL_STACK_SYMMETRIC)
layout(set = 0, binding = 1) uniform utexture2D tables;

uvec4 lq_table_texel(const int index) {
    return texelFetch(tables, ivec2(index % LQ_TABLE_COLUMNS, index / LQ_TABLE_COLUMNS), 0);
}
#endif

#endif
