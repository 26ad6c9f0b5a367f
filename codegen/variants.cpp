#include "codegen/variants.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/error.h"

namespace lacquer::codegen {

namespace {

constexpr std::array kLevels{
    Level{"plain", "plain/plain.glsl", "LQ_MODEL_PLAIN",
          "a rough dielectric coat over a bare base, no light passing between them"},
    Level{"clearcoat", "clearcoat/clearcoat.glsl", "LQ_MODEL_CLEARCOAT",
          "glTF's clear coat: Fresnel's factor divides the light between coat and base"},
    Level{"weidlich_wilkie", "weidlich_wilkie/weidlich_wilkie.glsl", "LQ_MODEL_WEIDLICH_WILKIE",
          "a coat that light enters and leaves through the same facet, by Weidlich and Wilkie"},
    Level{"openpbr_coat", "openpbr_coat/openpbr_coat.glsl", "LQ_MODEL_OPENPBR_COAT",
          "OpenPBR's coat: the base made rougher, darker and attenuated by it"},
    Level{"coated", "coated/coated.glsl", "LQ_MODEL_COATED",
          "a rough dielectric coat over a Lambertian base, with all light between them", true},
    Level{"stack", "stack/stack.glsl", "LQ_MODEL_STACK",
          "any number of rough layers over any base, with all light between them", true, true},
    Level{"stack_symmetric", "stack_symmetric/stack_symmetric.glsl", "LQ_MODEL_STACK_SYMMETRIC",
          "the same stacks, reciprocal: light is followed when a surface is prepared", true, true},
    Level{"microsurface_single", "microsurface_single/microsurface_single.glsl",
          "LQ_MODEL_MICROSURFACE_SINGLE",
          "facets of several strata, one above the other or mixed: light that met one of them"},
    Level{"microsurface_compensated", "microsurface_compensated/microsurface_compensated.glsl",
          "LQ_MODEL_MICROSURFACE_COMPENSATED",
          "the same strata, with the light that met several facets as a diffuse lobe"},
};

struct StageEntry {
    Stage stage;
    std::string_view name;
    std::string_view folder;
    std::string_view extension;
};

constexpr std::array kStages{
    StageEntry{Stage::compute, "compute", "kernels", ".comp"},
    StageEntry{Stage::vertex, "vertex", "viewer", ".vert"},
    StageEntry{Stage::fragment, "fragment", "viewer", ".frag"},
};

}  // namespace

std::string_view stage_name(Stage stage) {
    return kStages[static_cast<std::size_t>(stage)].name;
}

std::span<const Level> all_levels() {
    return kLevels;
}

std::vector<std::string_view> level_names() {
    std::vector<std::string_view> names;
    for (const Level& level : kLevels) names.push_back(level.name);
    return names;
}

const Level& level_from_name(std::string_view name) {
    std::string known;
    for (const Level& level : kLevels) {
        if (level.name == name) return level;
        known += known.empty() ? "" : ", ";
        known += level.name;
    }
    throw UsageError{fmt::format("level '{}' is not one of: {}", name, known)};
}

std::string level_preamble(const Level& level, const StackChoices& stacks) {
    std::string lines = fmt::format("#define {} 1\n", level.define);
    if (level.reads_layers)
        lines += fmt::format("#define LQ_MAX_LAYERS {}\n#define LQ_STACK_LOBES {}\n",
                             stacks.max_layers, stacks.lobes);
    return lines;
}

void require_valid(const StackChoices& stacks) {
    const auto require = [](std::string_view name, int value, int min, int max) {
        if (value < min || value > max)
            throw UsageError{fmt::format("{}: {} is not in [{}, {}]", name, value, min, max)};
    };
    require("--max-layers", stacks.max_layers, kMinLayers, kMaxLayers);
    require("--stack-lobes", stacks.lobes, kMinLobes, kMaxLobes);
}

std::vector<KernelSource> all_kernels(const SourceTree& tree) {
    std::vector<KernelSource> kernels;
    for (const auto& [name, text] : tree.files()) {
        const std::filesystem::path path{name};
        for (const StageEntry& entry : kStages)
            if (path.parent_path() == entry.folder && path.extension() == entry.extension)
                kernels.push_back({path.stem().string(), name, entry.stage});
    }
    std::ranges::sort(kernels, {}, [](const KernelSource& kernel) {
        return std::pair{kernel.kernel, kernel.stage};
    });
    return kernels;
}

bool shades_surfaces(const SourceTree& tree, const KernelSource& source) {
    const std::vector<std::string> files = tree.closure(source.file);
    return std::ranges::find(files, "kernels/model.glsl") != files.end();
}

bool can_express(Target target, Stage stage) {
    return target != Target::essl300 || stage != Stage::compute;
}

bool can_express_library(Target target) {
    return target != Target::spirv;
}

}  // namespace lacquer::codegen
