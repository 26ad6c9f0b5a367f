// What every compute kernel reads and writes. The host's side of this layout is
// host/backends/kernel.h; one descriptor layout serves all kernels and languages.
#ifndef LQ_KERNELS_BINDINGS_GLSL
#define LQ_KERNELS_BINDINGS_GLSL

// `query_count` invocations have work. Query i shades surface i / queries_per_surface. `wo` is the
// viewer of `slice`, `radiance` the light of `sphere`, `point_count` the samples of `albedo`.
layout(set = 0, binding = 0, std140) uniform LqKernelParameters {
    uint query_count;
    uint queries_per_surface;
    uint point_count;
    uint reserved;
    vec4 wo;
    vec4 radiance;
} parameters;

// Flat vec4 rows, not structs: HLSL and WGSL agree on their layout without exception.
layout(set = 0, binding = 1, std430) readonly buffer LqSurfaces {
    vec4 rows[];
} surfaces;

// Row `index` of the packed surfaces: what unpacks them works for any buffer.
vec4 lq_packed_row(const uint index) {
    return surfaces.rows[index];
}

layout(set = 0, binding = 2, std430) readonly buffer LqInputs {
    vec4 rows[];
} inputs;

layout(set = 0, binding = 3, std430) buffer LqResults {
    vec4 rows[];
} results;

// Of all levels, these read tables.
#if defined(LQ_MODEL_COATED) || defined(LQ_MODEL_STACK) || defined(LQ_MODEL_STACK_SYMMETRIC)
// The baked tables (shader_src/tables/texels.glsl).
layout(set = 0, binding = 4, std430) readonly buffer LqTables {
    uvec4 texels[];
} tables;

uvec4 lq_table_texel(const int index) {
    return tables.texels[index];
}
#endif

layout(local_size_x = 64, local_size_y = 1, local_size_z = 1) in;

vec3 lq_input_vector(const uint row) {
    return vec3(inputs.rows[row].x, inputs.rows[row].y, inputs.rows[row].z);
}

#endif
