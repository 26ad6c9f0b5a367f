#include "codegen/reflect.h"

#include <algorithm>
#include <spirv_cross/spirv_cross.hpp>

namespace lacquer::codegen {

namespace {

std::string_view stage_of(spv::ExecutionModel model) {
    switch (model) {
        case spv::ExecutionModelVertex:
            return "vertex";
        case spv::ExecutionModelFragment:
            return "fragment";
        default:
            return "compute";
    }
}

}  // namespace

Reflection reflect(const Words& words) {
    const spirv_cross::Compiler compiler{words};
    Reflection reflection;
    for (const auto& entry : compiler.get_entry_points_and_stages()) {
        EntryPoint point{entry.name, std::string{stage_of(entry.execution_model)}};
        if (entry.execution_model == spv::ExecutionModelGLCompute)
            for (unsigned axis = 0; axis < 3; ++axis)
                point.workgroup_size[axis] =
                    compiler.get_execution_mode_argument(spv::ExecutionModeLocalSize, axis);
        reflection.entry_points.push_back(point);
    }
    const spirv_cross::ShaderResources resources = compiler.get_shader_resources();
    const auto add = [&](const auto& list, std::string_view kind) {
        for (const spirv_cross::Resource& resource : list) {
            std::string exact{kind};
            if (kind == "storage") {
                const bool read_only =
                    compiler.get_buffer_block_flags(resource.id).get(spv::DecorationNonWritable);
                exact = read_only ? "storage_read" : "storage_read_write";
            }
            reflection.bindings.push_back(
                {compiler.get_name(resource.id),
                 compiler.get_decoration(resource.id, spv::DecorationDescriptorSet),
                 compiler.get_decoration(resource.id, spv::DecorationBinding), exact});
        }
    };
    add(resources.uniform_buffers, "uniform");
    add(resources.storage_buffers, "storage");
    add(resources.separate_images, "texture");
    add(resources.separate_samplers, "sampler");
    std::ranges::sort(reflection.bindings, {}, [](const Binding& b) {
        return std::pair{b.set, b.binding};
    });
    return reflection;
}

}  // namespace lacquer::codegen
