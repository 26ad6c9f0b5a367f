#include "shading/plain_parameters.h"

#include <fmt/format.h>

#include "core/error.h"

namespace lacquer {

namespace {

const Microsurface& uniform(const Roughness& roughness, const Material& material,
                            const char* pointer) {
    const auto* microsurface = std::get_if<Microsurface>(&roughness);
    if (microsurface == nullptr)
        throw Error{fmt::format(
            "material '{}': {}/blend: the model 'plain' cannot shade a blended microsurface",
            material.name, pointer)};
    return *microsurface;
}

Rgb relative(Rgb index, double exterior_ior) {
    for (double& channel : index) channel /= exterior_ior;
    return index;
}

}  // namespace

PlainParameters plain_parameters(const Material& material) {
    PlainParameters parameters;
    if (!material.layers.empty()) {
        const Interface& top = material.layers.front().interface;
        parameters.coat = uniform(top.roughness, material, "/layers/0/interface");
        parameters.coat_eta = top.ior / material.exterior_ior;
    }
    if (const auto* lambertian = std::get_if<LambertianBase>(&material.base)) {
        parameters.base_kind = PlainParameters::BaseKind::lambertian;
        parameters.albedo = lambertian->albedo;
    } else if (const auto* diffuse = std::get_if<DiffuseFacetsBase>(&material.base)) {
        uniform(diffuse->roughness, material, "/base/diffuse_facets");
        parameters.base_kind = PlainParameters::BaseKind::lambertian;
        parameters.albedo = diffuse->albedo;
    } else if (const auto* conductor = std::get_if<ConductorBase>(&material.base)) {
        parameters.base_kind = PlainParameters::BaseKind::conductor;
        parameters.base_facets = uniform(conductor->roughness, material, "/base/conductor");
        parameters.eta = relative(conductor->eta, material.exterior_ior);
        parameters.kappa = relative(conductor->kappa, material.exterior_ior);
    }
    return parameters;
}

}  // namespace lacquer
