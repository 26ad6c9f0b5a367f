#include "shading/stack_parameters.h"

#include "core/model_scope.h"
#include "shading/optical_depth.h"

namespace lacquer {

namespace {

StackParameters::Layer layer_parameters(const Layer& layer, double exterior_ior) {
    StackParameters::Layer parameters{std::get<Microsurface>(layer.interface.roughness),
                                      layer.interface.ior / exterior_ior,
                                      optical_depth(layer.medium)};
    if (const auto* slab = std::get_if<ScatteringMedium>(&layer.medium)) {
        for (std::size_t i = 0; i < parameters.scattering.size(); ++i)
            parameters.scattering[i] = slab->sigma_s[i] * slab->thickness;
        parameters.g = slab->g;
    }
    return parameters;
}

}  // namespace

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
