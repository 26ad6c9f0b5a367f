// GLSL and GLSL ES through SPIRV-Cross.
#include <spirv_cross/spirv_glsl.hpp>

#include "codegen/emit.h"

namespace lacquer::codegen {

namespace {

unsigned glsl_version(Target target) {
    if (target == Target::essl300) return 300;
    return target == Target::essl310 ? 310 : 450;
}

// GLSL has no separate textures and samplers: pairs become one, named after the texture, at its
// binding. Textures that are read without a sampler are paired with none.
void combine_samplers(spirv_cross::CompilerGLSL& compiler) {
    compiler.build_dummy_sampler_for_combined_images();
    compiler.build_combined_image_samplers();
    for (const auto& pair : compiler.get_combined_image_samplers()) {
        compiler.set_name(pair.combined_id, compiler.get_name(pair.image_id));
        compiler.set_decoration(pair.combined_id, spv::DecorationBinding,
                                compiler.get_decoration(pair.image_id, spv::DecorationBinding));
    }
}

}  // namespace

text::Statements emit_glsl(const Words& words, Target target) {
    spirv_cross::CompilerGLSL compiler{words};
    spirv_cross::CompilerGLSL::Options options;
    options.version = glsl_version(target);
    options.es = target != Target::glsl450;
    options.vertex.flip_vert_y = true;  // the source is Vulkan's, whose y points down
    options.fragment.default_float_precision = spirv_cross::CompilerGLSL::Options::Highp;
    options.fragment.default_int_precision = spirv_cross::CompilerGLSL::Options::Highp;
    compiler.set_common_options(options);
    combine_samplers(compiler);
    text::Statements statements = text::parse(compiler.compile(), text::Dialect::glsl);
    tidy_c_family(statements, text::Dialect::glsl);
    return statements;
}

}  // namespace lacquer::codegen
