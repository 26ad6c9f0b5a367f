#include "core/model_scope.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "core/error.h"

namespace lacquer {

namespace {

// A feature of a material that a model has no formula for is either left out, as the model's
// description says, or refused.
enum class Extra { left_out, refused };

struct Scope {
    Extra deeper_layers;  // those below the first
    Extra scattering;
    bool lambertian_only = false;  // a coat over a Lambertian base, and nothing else
};

Scope scope_of(Model model) {
    switch (model) {
        case Model::plain:
            return {Extra::left_out, Extra::left_out};
        case Model::clearcoat:
        case Model::weidlich_wilkie:
        case Model::openpbr_coat:
            break;
        case Model::coated_ggx:
        case Model::coated_exact:
            return {Extra::refused, Extra::refused, true};
    }
    return {Extra::refused, Extra::refused};
}

struct Refusal {
    std::string_view pointer;
    std::string_view why;
};

bool scatters(const Medium& medium) {
    const auto* scattering = std::get_if<ScatteringMedium>(&medium);
    return scattering != nullptr &&
           std::ranges::any_of(scattering->sigma_s, [](double sigma) { return sigma > 0.0; });
}

bool is_blend(const Roughness& roughness) {
    return std::holds_alternative<Blend>(roughness);
}

constexpr std::string_view kNoBlend = "cannot shade a blended microsurface";

std::optional<Refusal> refused_layers(const std::vector<Layer>& layers, const Scope& scope) {
    if (layers.empty() && scope.lambertian_only)
        return Refusal{"/layers", "shades one layer over a Lambertian base, and there is none"};
    if (layers.empty()) return std::nullopt;
    if (scope.deeper_layers == Extra::refused && layers.size() > 1)
        return Refusal{"/layers/1", "shades at most one layer"};
    if (is_blend(layers[0].interface.roughness))
        return Refusal{"/layers/0/interface/blend", kNoBlend};
    if (scope.scattering == Extra::refused && scatters(layers[0].medium))
        return Refusal{"/layers/0/medium/sigma_s", "cannot shade a medium that scatters"};
    return std::nullopt;
}

std::optional<Refusal> refused_base(const Base& base, const Scope& scope) {
    if (scope.lambertian_only && !std::holds_alternative<LambertianBase>(base))
        return Refusal{"/base", "shades Lambertian bases only"};
    const auto* diffuse = std::get_if<DiffuseFacetsBase>(&base);
    if (diffuse != nullptr && is_blend(diffuse->roughness))
        return Refusal{"/base/diffuse_facets/blend", kNoBlend};
    const auto* conductor = std::get_if<ConductorBase>(&base);
    if (conductor != nullptr && is_blend(conductor->roughness))
        return Refusal{"/base/conductor/blend", kNoBlend};
    return std::nullopt;
}

}  // namespace

std::optional<std::string> why_not_shadeable(const Material& material, Model model) {
    std::optional<Refusal> refusal = refused_layers(material.layers, scope_of(model));
    if (!refusal) refusal = refused_base(material.base, scope_of(model));
    if (!refusal) return std::nullopt;
    return fmt::format("{}: the model '{}' {}", refusal->pointer, model_name(model), refusal->why);
}

void require_shadeable(const Material& material, Model model) {
    if (const auto why = why_not_shadeable(material, model))
        throw Error{fmt::format("material '{}': {}", material.name, *why)};
}

}  // namespace lacquer
