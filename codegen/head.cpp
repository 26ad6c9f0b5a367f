#include "codegen/head.h"

#include <fmt/format.h>

#include "codegen/emit.h"
#include "codegen/targets.h"
#include "core/version.h"

namespace lacquer::codegen {

namespace {

std::string form_description(const ShaderFile& file) {
    if (file.form == Form::kernel) return fmt::format("kernel '{}'", file.kernel);
    const bool embedded = file.target == Target::essl300 || file.target == Target::essl310;
    return embedded ? "functions only, for a shader with `precision highp float; precision highp "
                      "int;`"
                    : "functions only, nothing bound";
}

// Conventions that a reader of the functions needs; lacquer.glsl has them at length.
constexpr std::string_view kConventions =
    "//\n"
    "// Directions are unit vectors in a local frame whose z is the normal: wi towards the light, "
    "wo\n"
    "// towards the viewer, wm a facet normal. f is the BSDF per steradian without the cosine; a "
    "name\n"
    "// ending in _cos includes cos_theta_i. eta is ior below / ior above an interface, a "
    "conductor's\n"
    "// index is eta + i kappa, alpha is the slope roughness of the papers.\n";

// How to supply the packed tables. In Metal nothing that is bound can be seen by all functions.
std::string_view table_access(text::Dialect dialect) {
    switch (dialect) {
        case text::Dialect::hlsl:
            return "uint4 lq_table_texel(int index) { return TABLES.Load(int3(index % 128, index / "
                   "128, 0)); }";
        case text::Dialect::wgsl:
            return "fn lq_table_texel(index: i32) -> vec4u { return textureLoad(TABLES, "
                   "vec2i(index "
                   "% 128, index / 128), 0); }";
        case text::Dialect::msl:
            return "static inline uint4 lq_table_texel(int index) { return TABLES[index]; }  // "
                   "constant uint4 TABLES[]";
        case text::Dialect::glsl:
            break;
    }
    return "uvec4 lq_table_texel(int index) { return texelFetch(TABLES, ivec2(index % 128, index / "
           "128), 0); }";
}

// What a level that reads tables asks for.
std::string tables_wanted(Target target) {
    return fmt::format(
        "//\n"
        "// Define lq_table_texel above: a texel, unfiltered, of the packed tables that "
        "manifest.json "
        "lists.\n"
        "// From a texture of them, or likewise from a buffer:\n"
        "//     {}\n",
        table_access(dialect_of(target)));
}

// How to supply the layers of a stack.
std::string_view layer_access(text::Dialect dialect) {
    switch (dialect) {
        case text::Dialect::hlsl:
            return "float4 lq_stack_row(int index) { return LAYERS[index]; }";
        case text::Dialect::wgsl:
            return "fn lq_stack_row(index: i32) -> vec4f { return LAYERS[index]; }";
        case text::Dialect::msl:
            return "static inline float4 lq_stack_row(int index) { return LAYERS[index]; }";
        case text::Dialect::glsl:
            break;
    }
    return "vec4 lq_stack_row(int index) { return LAYERS[index]; }";
}

// What a level of layers asks for.
std::string layers_wanted(Target target) {
    return fmt::format(
        "//\n"
        "// Define lq_stack_row above: a row of the layers' parameters, three for each layer "
        "and one\n"
        "// for each stratum of a blended interface (LqStackMaterial),\n"
        "// from a buffer or an array:\n"
        "//     {}\n",
        layer_access(dialect_of(target)));
}

}  // namespace

std::string file_head(const ShaderFile& file, const Level& level, const StackChoices& stacks,
                      const std::string& source_sha256) {
    std::string head = fmt::format(
        "// Lacquer {}, {}: {}.\n"
        "// {}, {}.\n"
        "// SPDX-License-Identifier: Apache-2.0\n"
        "// Generated; source sha256 {}.\n",
        kVersion, level.name, level.description, target_entry(file.target).description,
        form_description(file), source_sha256);
    if (level.reads_layers)
        head += fmt::format("// Chosen at export: LQ_MAX_LAYERS {}, LQ_STACK_LOBES {}.\n",
                            stacks.max_layers, stacks.lobes);
    if (file.form == Form::library) head += kConventions;
    if (file.form == Form::library && level.reads_tables) head += tables_wanted(file.target);
    if (file.form == Form::library && level.reads_layers) head += layers_wanted(file.target);
    return head + "\n";
}

}  // namespace lacquer::codegen
