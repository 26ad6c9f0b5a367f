#include "codegen/targets.h"

#include <fmt/format.h>

#include <array>

#include "core/error.h"

namespace lacquer::codegen {

namespace {

constexpr std::array kTargets{
    TargetEntry{Target::spirv, "spirv", "spv", "SPIR-V 1.3"},
    TargetEntry{Target::glsl450, "glsl450", "glsl", "GLSL 4.50"},
    TargetEntry{Target::essl310, "essl310", "glsl", "GLSL ES 3.10"},
    TargetEntry{Target::essl300, "essl300", "glsl", "GLSL ES 3.00"},
    TargetEntry{Target::hlsl50, "hlsl50", "hlsl", "HLSL, shader model 5.0"},
    TargetEntry{Target::hlsl60, "hlsl60", "hlsl", "HLSL, shader model 6.0"},
    TargetEntry{Target::msl, "msl", "metal", "Metal Shading Language 2.2"},
    TargetEntry{Target::wgsl, "wgsl", "wgsl", "WGSL"},
};

constexpr auto kTargetList = [] {
    std::array<Target, kTargets.size()> list{};
    for (std::size_t i = 0; i < list.size(); ++i) list[i] = kTargets[i].target;
    return list;
}();

}  // namespace

const TargetEntry& target_entry(Target target) {
    return kTargets[static_cast<std::size_t>(target)];
}

std::string_view target_name(Target target) {
    return target_entry(target).name;
}

std::string_view form_name(Form form) {
    return form == Form::kernel ? "kernel" : "library";
}

std::span<const Target> all_targets() {
    return kTargetList;
}

Target target_from_name(std::string_view name) {
    std::string known;
    for (const TargetEntry& entry : kTargets) {
        if (entry.name == name) return entry.target;
        known += fmt::format("{}{}", known.empty() ? "" : ", ", entry.name);
    }
    throw UsageError{fmt::format("target '{}' is not one of: {}", name, known)};
}

Form form_from_name(std::string_view name) {
    for (const Form form : {Form::kernel, Form::library})
        if (form_name(form) == name) return form;
    throw UsageError{fmt::format("form '{}' is not one of: kernel, library", name)};
}

}  // namespace lacquer::codegen
