#include "codegen/head.h"

#include <fmt/format.h>

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

// What a level that reads tables asks for.
constexpr std::string_view kTables =
    "//\n"
    "// Define lq_table_texel(index), of four floats, above: it returns a texel of the packed tables,\n"
    "// unfiltered.\n";

}  // namespace

std::string file_head(const ShaderFile& file, const Level& level,
                      const std::string& source_sha256) {
    std::string head = fmt::format(
        "// Lacquer {}, {}: {}.\n"
        "// {}, {}.\n"
        "// SPDX-License-Identifier: Apache-2.0\n"
        "// Generated; source sha256 {}.\n",
        kVersion, level.name, level.description, target_entry(file.target).description,
        form_description(file), source_sha256);
    if (file.form == Form::library) head += kConventions;
    if (file.form == Form::library && level.reads_tables) head += kTables;
    return head + "\n";
}

}  // namespace lacquer::codegen
