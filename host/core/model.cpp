#include "core/model.h"

#include <fmt/format.h>

#include <array>
#include <string>

#include "core/error.h"

namespace lacquer {

namespace {

struct ModelEntry {
    Model model;
    std::string_view name;
    std::string_view level;
    bool reads_tables = false;
};

// In the order of Model.
constexpr std::array kEntries{
    ModelEntry{Model::plain, "plain", "plain"},
    ModelEntry{Model::clearcoat, "clearcoat", "clearcoat"},
    ModelEntry{Model::weidlich_wilkie, "weidlich-wilkie", "weidlich_wilkie"},
    ModelEntry{Model::openpbr_coat, "openpbr-coat", "openpbr_coat"},
    ModelEntry{Model::coated_ggx, "coated-ggx", "coated", true},
    ModelEntry{Model::coated_exact, "coated-exact", "coated", true},
    ModelEntry{Model::stack, "stack", "stack", true},
    ModelEntry{Model::stack_symmetric, "stack-symmetric", "stack_symmetric", true},
    ModelEntry{Model::microsurface_single, "microsurface-single", "microsurface_single"},
    ModelEntry{Model::microsurface_compensated, "microsurface-compensated",
               "microsurface_compensated"},
};

constexpr auto kModels = [] {
    std::array<Model, kEntries.size()> models{};
    for (std::size_t i = 0; i < models.size(); ++i) models[i] = kEntries[i].model;
    return models;
}();

const ModelEntry& entry_of(Model model) {
    return kEntries[static_cast<std::size_t>(model)];
}

}  // namespace

std::string_view model_name(Model model) {
    return entry_of(model).name;
}

std::string_view model_level(Model model) {
    return entry_of(model).level;
}

bool reads_tables(Model model) {
    return entry_of(model).reads_tables;
}

Model model_from_name(std::string_view name) {
    std::string known;
    for (const ModelEntry& entry : kEntries) {
        if (entry.name == name) return entry.model;
        known += known.empty() ? "" : ", ";
        known += entry.name;
    }
    throw UsageError{fmt::format("model '{}' is not one of: {}", name, known)};
}

std::span<const Model> all_models() {
    return kModels;
}

}  // namespace lacquer
