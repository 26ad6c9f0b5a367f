// HLSL through SPIRV-Cross.
#include <spirv_cross/spirv_hlsl.hpp>

#include "codegen/emit.h"

namespace lacquer::codegen {

std::string emit_hlsl(const Words& words, Target target) {
    spirv_cross::CompilerHLSL compiler{words};
    spirv_cross::CompilerHLSL::Options options;
    options.shader_model = target == Target::hlsl50 ? 50 : 60;
    compiler.set_hlsl_options(options);
    return compiler.compile();
}

}  // namespace lacquer::codegen
