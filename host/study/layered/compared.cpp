#include "study/layered/compared.h"

#include <array>

#include "core/error.h"
#include "core/model_scope.h"
#include "core/paths.h"
#include "study/layered/stack_shading.h"

namespace lacquer::study {

namespace {

constexpr std::array kBaselines{Model::weidlich_wilkie, Model::clearcoat, Model::plain};

// Under a black base all light is what never reached it.
Material over_black(Material material) {
    material.base = LambertianBase{};
    return material;
}

Compared stack_on(const Material& material, Need need) {
    static const EnergyTables tables{share_folder() / "tables"};
    Compared compared{"stack"};
    try {
        compared.light.emplace(
            compared.name, stack_shading(material, tables),
            need == Need::base ? stack_shading(over_black(material), tables) : nullptr);
    } catch (const Error& error) {
        compared.why_not = error.what();
    }
    return compared;
}

Compared baseline_on(const Material& material, Model model) {
    Compared compared{std::string{model_name(model)}};
    if (const auto why_not = why_not_shadeable(material, model))
        compared.why_not = *why_not;
    else
        compared.light.emplace(material, model);
    return compared;
}

}  // namespace

std::vector<Compared> compared_on(const Material& material, Need need) {
    std::vector<Compared> all{stack_on(material, need)};
    for (const Model model : kBaselines) all.push_back(baseline_on(material, model));
    return all;
}

std::vector<ModelLight> lights_of(const std::vector<Compared>& compared) {
    std::vector<ModelLight> lights;
    for (const Compared& one : compared)
        if (one.light) lights.push_back(*one.light);
    return lights;
}

}  // namespace lacquer::study
