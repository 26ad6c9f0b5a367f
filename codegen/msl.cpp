// Metal Shading Language through SPIRV-Cross.
#include <spirv_cross/spirv_msl.hpp>

#include "codegen/emit.h"

namespace lacquer::codegen {

std::string emit_msl(const Words& words) {
    spirv_cross::CompilerMSL compiler{words};
    spirv_cross::CompilerMSL::Options options;
    options.set_msl_version(2, 2);
    options.enable_decoration_binding = true;
    compiler.set_msl_options(options);
    return compiler.compile();
}

}  // namespace lacquer::codegen
