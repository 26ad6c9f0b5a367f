#include "shading/stack_parameters.h"

#include "core/model_scope.h"
#include "shading/optical_depth.h"

namespace lacquer {

namespace {

StackParameters::Layer layer_parameters(const Layer& layer, double exterior_ior) {
    StackParameters::Layer parameters;
    if (const auto* blend = std::get_if<Blend>(&layer.interface.roughness)) {
        parameters.op = blend->op;
        for (const Stratum& stratum : blend->strata)
            parameters.strata.push_back({stratum.microsurface, stratum.weight});
    } else {
        parameters.strata = {{std::get<Microsurface>(layer.interface.roughness)}};
    }
    parameters.index = layer.interface.ior / exterior_ior;
    parameters.absorption = optical_depth(layer.medium);
    if (const auto* slab = std::get_if<ScatteringMedium>(&layer.medium)) {
        for (std::size_t i = 0; i < parameters.scattering.size(); ++i)
            parameters.scattering[i] = slab->sigma_s[i] * slab->thickness;
        parameters.g = slab->g;
    }
    return parameters;
}

}  // namespace

std::vector<std::array<double, 4>> layer_rows(const StackParameters& stack) {
    constexpr double kBlended = -1.0;                                       // LQ_STACK_BLENDED
    const auto ndf = [](Ndf n) { return n == Ndf::beckmann ? 1.0 : 0.0; };  // LQ_NDF_*
    std::vector<std::array<double, 4>> rows, strata;
    const std::size_t first_stratum = 3 * stack.layers.size();
    for (const StackParameters::Layer& layer : stack.layers) {
        const Microsurface& top = layer.strata.front().microsurface;
        const bool is_blend = layer.strata.size() > 1;
        const double begin = is_blend ? static_cast<double>(first_stratum + strata.size()) : 0.0;
        if (is_blend)
            rows.push_back({static_cast<double>(layer.strata.size()),
                            layer.op == Blend::Operator::symmetric ? 1.0 : 0.0,  // LQ_BLEND_*
                            layer.index, kBlended});
        else
            rows.push_back({top.alpha[0], top.alpha[1], layer.index, ndf(top.ndf)});
        rows.push_back({layer.absorption[0], layer.absorption[1], layer.absorption[2], layer.g});
        rows.push_back({layer.scattering[0], layer.scattering[1], layer.scattering[2], begin});
        if (!is_blend) continue;
        for (const auto& [microsurface, weight] : layer.strata)
            strata.push_back(
                {microsurface.alpha[0], microsurface.alpha[1], weight, ndf(microsurface.ndf)});
    }
    rows.insert(rows.end(), strata.begin(), strata.end());
    return rows;
}

StackParameters stack_parameters(const Material& material, Model model) {
    require_shadeable(material, model);
    StackParameters parameters;
    for (const Layer& layer : material.layers)
        parameters.layers.push_back(layer_parameters(layer, material.exterior_ior));
    if (const auto* lambertian = std::get_if<LambertianBase>(&material.base)) {
        parameters.base_kind = StackParameters::BaseKind::lambertian;
        parameters.albedo = lambertian->albedo;
    } else if (const auto* conductor = std::get_if<ConductorBase>(&material.base)) {
        parameters.base_kind = StackParameters::BaseKind::conductor;
        parameters.base_facets = std::get<Microsurface>(conductor->roughness);
        parameters.eta = relative_index(conductor->eta, material.exterior_ior);
        parameters.kappa = relative_index(conductor->kappa, material.exterior_ior);
    }
    return parameters;
}

}  // namespace lacquer
