#include "core/model_scope.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "core/error.h"

namespace lacquer {

namespace {

// A feature of a material that a model has no formula for is either left out, as the model's
// description says, or refused.
enum class Extra { shaded, left_out, refused };

struct Scope {
    Extra deeper_layers;  // those below the first
    Extra scattering;
    bool lambertian_only = false;  // a coat over a Lambertian base, and nothing else
    bool whole_stacks = false;     // at least one layer, and bases as they are
    bool one_surface = false;      // one interface or one conductor, uniform or blended
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
        case Model::stack:
        case Model::stack_symmetric:
            return {Extra::shaded, Extra::shaded, false, true};
        case Model::microsurface_single:
        case Model::microsurface_compensated:
            return {Extra::refused, Extra::refused, false, false, true};
    }
    return {Extra::refused, Extra::refused};
}

struct Refusal {
    std::string pointer;
    std::string why;
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

std::optional<Refusal> refused_strata(const Roughness& roughness, const std::string& pointer) {
    const auto* blend = std::get_if<Blend>(&roughness);
    if (blend == nullptr || blend->strata.size() <= kMaxStrata) return std::nullopt;
    return Refusal{fmt::format("{}/blend/strata/{}", pointer, kMaxStrata),
                   fmt::format("shades at most {} strata", kMaxStrata)};
}

std::optional<Refusal> refused_layer(const Layer& layer, const std::string& pointer,
                                     const Scope& scope) {
    if (scope.whole_stacks) {
        if (auto refusal = refused_strata(layer.interface.roughness, pointer + "/interface"))
            return refusal;
    } else if (!scope.one_surface && is_blend(layer.interface.roughness)) {
        return Refusal{pointer + "/interface/blend", std::string{kNoBlend}};
    }
    if (scope.scattering == Extra::refused && scatters(layer.medium))
        return Refusal{pointer + "/medium/sigma_s", "cannot shade a medium that scatters"};
    return std::nullopt;
}

std::optional<Refusal> refused_layers(const std::vector<Layer>& layers, const Scope& scope) {
    if (layers.empty() && scope.lambertian_only)
        return Refusal{"/layers", "shades one layer over a Lambertian base, and there is none"};
    if (layers.empty() && scope.whole_stacks) return Refusal{"/layers", "needs at least one layer"};
    if (scope.whole_stacks && layers.size() > kMaxLayers)
        return Refusal{fmt::format("/layers/{}", kMaxLayers),
                       fmt::format("shades at most {} layers", kMaxLayers)};
    if (scope.deeper_layers == Extra::refused && layers.size() > 1)
        return Refusal{"/layers/1", "shades at most one layer"};
    const std::size_t shaded = scope.whole_stacks ? layers.size() : 1;
    for (std::size_t n = 0; n < std::min(shaded, layers.size()); ++n)
        if (auto refusal = refused_layer(layers[n], fmt::format("/layers/{}", n), scope))
            return refusal;
    return std::nullopt;
}

// Of a surface that stands alone.
std::optional<Refusal> refused_surface(const Material& material) {
    if (!material.layers.empty()) {
        if (std::holds_alternative<NoBase>(material.base))
            return refused_strata(material.layers.front().interface.roughness,
                                  "/layers/0/interface");
        return Refusal{"/base", "shades an interface without a base, or a bare conductor"};
    }
    const auto* conductor = std::get_if<ConductorBase>(&material.base);
    if (conductor == nullptr)
        return Refusal{"/base", "shades bare conductors only, or an interface without a base"};
    if (const auto* blend = std::get_if<Blend>(&conductor->roughness))
        for (std::size_t k = 0; k < blend->strata.size(); ++k)
            if (blend->strata[k].albedo)
                return Refusal{fmt::format("/base/conductor/blend/strata/{}/albedo", k),
                               "cannot shade diffuse facets"};
    return refused_strata(conductor->roughness, "/base/conductor");
}

std::optional<Refusal> refused_base(const Base& base, const Scope& scope) {
    if (scope.lambertian_only && !std::holds_alternative<LambertianBase>(base))
        return Refusal{"/base", "shades Lambertian bases only"};
    const auto* diffuse = std::get_if<DiffuseFacetsBase>(&base);
    if (diffuse != nullptr && scope.whole_stacks)
        return Refusal{"/base/diffuse_facets", "cannot shade diffuse facets"};
    if (diffuse != nullptr && is_blend(diffuse->roughness))
        return Refusal{"/base/diffuse_facets/blend", std::string{kNoBlend}};
    const auto* conductor = std::get_if<ConductorBase>(&base);
    if (conductor != nullptr && is_blend(conductor->roughness))
        return Refusal{"/base/conductor/blend", std::string{kNoBlend}};
    return std::nullopt;
}

}  // namespace

std::optional<std::string> why_not_shadeable(const Material& material, Model model) {
    const Scope scope = scope_of(model);
    std::optional<Refusal> refusal = refused_layers(material.layers, scope);
    if (!refusal)
        refusal =
            scope.one_surface ? refused_surface(material) : refused_base(material.base, scope);
    if (!refusal) return std::nullopt;
    return fmt::format("{}: the model '{}' {}", refusal->pointer, model_name(model), refusal->why);
}

std::vector<Model> models_for(const Material& material) {
    std::vector<Model> models;
    for (const Model model : all_models())
        if (!why_not_shadeable(material, model)) models.push_back(model);
    return models;
}

void require_shadeable(const Material& material, Model model) {
    if (const auto why = why_not_shadeable(material, model))
        throw Error{fmt::format("material '{}': {}", material.name, *why)};
}

}  // namespace lacquer
