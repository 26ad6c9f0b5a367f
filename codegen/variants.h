// What is generated: the levels of the library and the kernels of each.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "codegen/codegen.h"
#include "codegen/source_tree.h"

namespace lacquer::codegen {

// A public level of the library: the shader source file that it consists of, and the macro that
// makes it the model of the kernels.
struct Level {
    std::string_view name;
    std::string_view source;
    std::string_view define;
    std::string_view description;
    bool reads_tables = false;  // then whoever uses the library form supplies lq_table_texel
    bool reads_layers = false;  // and then lq_stack_row: it shades stacks
};

// The macros that make kernels shade by the level, and stacks what was chosen: lines of GLSL.
std::string level_preamble(const Level& level, const StackChoices& stacks);

// Throws UsageError naming the choice that is out of range, and the range.
void require_valid(const StackChoices& stacks);

enum class Stage { compute, vertex, fragment };

std::string_view stage_name(Stage stage);

// One shader file of shader_src: `kernel` is its name on the command line and in paths.
struct KernelSource {
    std::string kernel;
    std::string file;
    Stage stage;
};

std::span<const Level> all_levels();

// Throws UsageError listing the levels there are.
const Level& level_from_name(std::string_view name);

// Every kernel of the tree, sorted by name and stage: kernels/*.comp, viewer/*.vert and *.frag.
std::vector<KernelSource> all_kernels(const SourceTree& tree);

// Whether the kernel runs a model; one that does not is the same for every level and is generated
// for the first only.
bool shades_surfaces(const SourceTree& tree, const KernelSource& source);

// Whether `target` can express a kernel of that stage; ESSL 3.00 has no compute shaders.
bool can_express(Target target, Stage stage);

// Whether `target` can express functions without an entry point; SPIR-V for Vulkan cannot.
bool can_express_library(Target target);

}  // namespace lacquer::codegen
