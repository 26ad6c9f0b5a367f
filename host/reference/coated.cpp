#include "reference/coated.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/error.h"

namespace lacquer::reference {

namespace {

[[noreturn]] void refuse(const Material& material, std::string_view pointer,
                         std::string_view found) {
    throw Error{fmt::format(
        "material '{}': {}: {}; the coated models shade one layer over a Lambertian base",
        material.name, pointer, found)};
}

const Layer& only_layer(const Material& material) {
    if (material.layers.size() != 1)
        refuse(material, "/layers", fmt::format("{} layers", material.layers.size()));
    return material.layers.front();
}

glm::dvec3 transmittance(const Material& material, const Medium& medium) {
    if (const auto* absorbing = std::get_if<AbsorbingMedium>(&medium))
        return vector_of(absorbing->tau);
    const auto& slab = std::get<ScatteringMedium>(medium);
    if (slab.sigma_s != Rgb{} && slab.thickness > 0.0)
        refuse(material, "/layers/0/medium/sigma_s", "the medium scatters");
    glm::dvec3 tau;
    for (int channel = 0; channel < 3; ++channel)
        tau[channel] = std::exp(-slab.sigma_a[static_cast<std::size_t>(channel)] * slab.thickness);
    return tau;
}

glm::dvec3 lambertian_albedo(const Material& material) {
    const auto* lambertian = std::get_if<LambertianBase>(&material.base);
    if (!lambertian) refuse(material, "/base", "not Lambertian");
    return vector_of(lambertian->albedo);
}

// The probability of choosing the coat for a viewer at wo.
double coat_choice(const CoatedSurface& surface, const glm::dvec3& wo) {
    const double coat = coat_albedo(surface.coat, wo);
    const double base = mean(base_albedo(surface.base, wo));
    if (coat <= 0.0) return 0.0;
    if (base <= 0.0) return 1.0;
    return std::clamp(coat / (coat + base), kMinChoice, 1.0 - kMinChoice);
}

}  // namespace

CoatedSurface prepare_coated(const Material& material, const EnergyTables& tables, BaseLobe shape) {
    const Layer& layer = only_layer(material);
    const glm::dvec3 tau = transmittance(material, layer.medium);
    const glm::dvec3 albedo = lambertian_albedo(material);
    const double eta = layer.interface.ior / material.exterior_ior;
    return {prepare_coat(layer.interface.roughness, eta, tables),
            prepare_coated_base(layer.interface.roughness, eta, albedo, tau, shape, tables)};
}

glm::dvec3 eval(const CoatedSurface& surface, const glm::dvec3& wi, const glm::dvec3& wo) {
    if (!is_above(wi) || !is_above(wo)) return glm::dvec3{0.0};
    return coat_lobe(surface.coat, wi, wo) + base_lobe(surface.base, wi, wo);
}

double pdf(const CoatedSurface& surface, const glm::dvec3& wi, const glm::dvec3& wo) {
    if (!is_above(wi) || !is_above(wo)) return 0.0;
    const double coat = coat_choice(surface, wo);
    return coat * coat_pdf(surface.coat, wi, wo) + (1.0 - coat) * base_pdf(surface.base, wi);
}

Sample sample(const CoatedSurface& surface, const glm::dvec3& wo, const glm::dvec3& u) {
    Sample chosen;
    if (!is_above(wo)) return chosen;
    const double coat = coat_choice(surface, wo);
    const glm::dvec2 point{u.y, u.z};
    chosen.wi = u.x < coat ? coat_sample(surface.coat, wo, u.x / coat, point)
                           : base_sample(surface.base, point);
    chosen.pdf = pdf(surface, chosen.wi, wo);
    if (chosen.pdf > 0.0) chosen.weight = eval(surface, chosen.wi, wo) * chosen.wi.z / chosen.pdf;
    return chosen;
}

Albedo albedo(const CoatedSurface& surface, const glm::dvec3& wo) {
    if (!is_above(wo)) return {};
    return {glm::dvec3{coat_albedo(surface.coat, wo)}, base_albedo(surface.base, wo)};
}

}  // namespace lacquer::reference
