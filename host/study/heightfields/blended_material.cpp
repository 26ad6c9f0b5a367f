#include "study/heightfields/blended_material.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace lacquer::study {

namespace {

Roughness& roughness_of(Material& material) {
    if (!material.layers.empty()) return material.layers.front().interface.roughness;
    if (auto* conductor = std::get_if<ConductorBase>(&material.base)) return conductor->roughness;
    return std::get<DiffuseFacetsBase>(material.base).roughness;
}

// The surface as if all of its facets were those of `stratum`.
Material uniform_of(const Material& blended, const Stratum& stratum) {
    Material material = blended;
    roughness_of(material) = stratum.microsurface;
    if (auto* conductor = std::get_if<ConductorBase>(&material.base)) {
        conductor->eta = stratum.eta.value_or(conductor->eta);
        conductor->kappa = stratum.kappa.value_or(conductor->kappa);
    }
    if (auto* diffuse = std::get_if<DiffuseFacetsBase>(&material.base))
        diffuse->albedo = stratum.albedo.value_or(diffuse->albedo);
    material.name.clear();
    return material;
}

}  // namespace

Stratum stratum(double weight, double alpha, Ndf ndf) {
    Stratum result;
    result.weight = weight;
    result.microsurface = {ndf, {alpha, alpha}};
    return result;
}

Blend asymmetric(std::vector<Stratum> strata) {
    return {Blend::Operator::asymmetric, std::move(strata)};
}

Blend symmetric(std::vector<Stratum> strata) {
    return {Blend::Operator::symmetric, std::move(strata)};
}

Material bare(std::string name, Base base) {
    Material material;
    material.name = std::move(name);
    material.base = std::move(base);
    return material;
}

void set_metal(Stratum& stratum, const Rgb& color) {
    // Fresnel's reflectance along the normal is kappa^2 / (4 + kappa^2).
    Rgb kappa;
    for (std::size_t c = 0; c < kappa.size(); ++c)
        kappa[c] = 2.0 * std::sqrt(color[c] / (1.0 - color[c]));
    stratum.eta = Rgb{1.0, 1.0, 1.0};
    stratum.kappa = kappa;
}

std::vector<UniformPart> uniform_parts(const Material& blended) {
    Material copy = blended;
    std::vector<UniformPart> parts;
    for (const Stratum& stratum : std::get<Blend>(roughness_of(copy)).strata) {
        const Material material = uniform_of(blended, stratum);
        const auto known = std::ranges::find(parts, material, &UniformPart::material);
        if (known == parts.end())
            parts.push_back({material, stratum.weight});
        else
            known->weight += stratum.weight;
    }
    return parts;
}

}  // namespace lacquer::study
