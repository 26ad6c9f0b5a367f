// Counts the texels that a surface reads: runs the shader source as C++ and listens.
#define LACQUER_TABLE_TEXEL(index) codegen::counted_texel(index)
#include <algorithm>
#include <array>

#include "codegen/cost.h"
#include "shading/table_texels.h"

namespace lacquer::codegen {

namespace {

// Per thread: packages may be generated side by side.
thread_local std::size_t texels_read = 0;

const glm::uvec4& counted_texel(int index) {
    ++texels_read;
    return kTableTexels[index];
}

}  // namespace

}  // namespace lacquer::codegen

#include "shading/shader_double.h"

namespace lacquer::codegen {

namespace {

std::size_t reads_of_coated(double eta, int base_lobe) {
    using namespace shader;
    texels_read = 0;
    lq_coated_prepare(LqCoatedMaterial{LqFacets{LQ_NDF_GGX, 0.3, 0.3}, eta, vec3{0.5, 0.5, 0.5},
                                       vec3{0.5, 0.5, 0.5}, base_lobe});
    return texels_read;
}

// Of a conductor's coat; further layers are read when light meets them. `prepare` is
// lq_LEVEL_prepare.
template <typename Prepare>
std::size_t reads_of_stack(const Prepare& prepare) {
    using namespace shader;
    const std::array rows{vec4{0.3, 0.3, 1.5, LQ_NDF_GGX}, vec4{0.0}, vec4{0.0}};
    const LqStackMaterial stack{0,
                                1,
                                LQ_STACK_BASE_CONDUCTOR,
                                vec3{0.0},
                                LqFacets{LQ_NDF_GGX, 0.3, 0.3},
                                vec3{0.2, 0.9, 1.1},
                                vec3{3.9, 2.5, 2.1}};
    stack_rows = rows.data();
    texels_read = 0;
    prepare(stack);
    return texels_read;
}

}  // namespace

// The tables of either side of eta 1 differ in size.
std::size_t table_reads(const Level& level) {
    if (!level.reads_tables) return 0;
    if (level.name == "stack") return reads_of_stack(shader::lq_stack_prepare);
    if (level.name == "stack_symmetric") return reads_of_stack(shader::lq_stack_symmetric_prepare);
    std::size_t most = 0;
    for (const double eta : {0.7, 1.5})
        for (const int base_lobe : {shader::LQ_BASE_LOBE_EXACT, shader::LQ_BASE_LOBE_GGX})
            most = std::max(most, reads_of_coated(eta, base_lobe));
    return most;
}

}  // namespace lacquer::codegen
