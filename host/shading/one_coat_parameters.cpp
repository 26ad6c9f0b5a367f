#include "shading/one_coat_parameters.h"

#include <cmath>

#include "core/model_scope.h"
#include "shading/optical_depth.h"

namespace lacquer {

Rgb transmittance(const OneCoatParameters& parameters) {
    Rgb tau = parameters.optical_depth;
    for (double& channel : tau) channel = std::exp(-channel);
    return tau;
}

OneCoatParameters one_coat_parameters(const Material& material, Model model) {
    require_shadeable(material, model);
    OneCoatParameters parameters;
    if (!material.layers.empty()) {
        const Layer& top = material.layers.front();
        parameters.coat = std::get<Microsurface>(top.interface.roughness);
        parameters.coat_eta = top.interface.ior / material.exterior_ior;
        parameters.optical_depth = optical_depth(top.medium);
    }
    if (const auto* lambertian = std::get_if<LambertianBase>(&material.base)) {
        parameters.base_kind = OneCoatParameters::BaseKind::lambertian;
        parameters.albedo = lambertian->albedo;
    } else if (const auto* diffuse = std::get_if<DiffuseFacetsBase>(&material.base)) {
        parameters.base_kind = OneCoatParameters::BaseKind::lambertian;
        parameters.albedo = diffuse->albedo;
    } else if (const auto* conductor = std::get_if<ConductorBase>(&material.base)) {
        parameters.base_kind = OneCoatParameters::BaseKind::conductor;
        parameters.base_facets = std::get<Microsurface>(conductor->roughness);
        parameters.eta = relative_index(conductor->eta, material.exterior_ior);
        parameters.kappa = relative_index(conductor->kappa, material.exterior_ior);
    }
    return parameters;
}

}  // namespace lacquer
