#include "reference/stack/layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.h"
#include "reference/equivalent_alpha.h"
#include "reference/fresnel.h"
#include "reference/shading.h"

namespace lacquer::reference {

namespace {

[[noreturn]] void refuse(const Material& material, const std::string& pointer,
                         const std::string& found) {
    throw Error{
        fmt::format("material '{}': {}: {}; stack shades uniform microsurfaces and absorbing media "
                    "over a conductor, a Lambertian base or none",
                    material.name, pointer, found)};
}

const Microsurface& uniform(const Material& material, const Roughness& roughness,
                            const std::string& pointer) {
    const auto* microsurface = std::get_if<Microsurface>(&roughness);
    if (!microsurface) refuse(material, pointer + "/blend", "the microsurface is blended");
    return *microsurface;
}

Energy transmittance(const Material& material, const Medium& medium, const std::string& pointer) {
    Energy tau{1.0};
    if (const auto* absorbing = std::get_if<AbsorbingMedium>(&medium)) {
        for (int channel = 0; channel < 3; ++channel)
            tau[channel] = absorbing->tau[static_cast<std::size_t>(channel)];
        return tau;
    }
    const auto& slab = std::get<ScatteringMedium>(medium);
    if (slab.sigma_s != Rgb{} && slab.thickness > 0.0)
        refuse(material, pointer + "/sigma_s", "the medium scatters");
    for (int channel = 0; channel < 3; ++channel)
        tau[channel] = std::exp(-slab.sigma_a[static_cast<std::size_t>(channel)] * slab.thickness);
    return tau;
}

StackInterface prepare_interface(const Microsurface& microsurface, double above, double below,
                                 const EnergyTables& tables) {
    const double eta = below / above;
    const double alpha = equivalent_ggx_alpha(microsurface, eta);
    return {alpha, above, below, tables.t_down_profile(alpha, eta, 1.0),
            tables.t_down_profile(alpha, 1.0 / eta, 1.0)};
}

// An isotropic roughness for an anisotropic one: the mean, as equivalent_alpha.h has it.
StackConductor prepare_conductor(const ConductorBase& base, const Microsurface& microsurface,
                                 double ior_above) {
    StackConductor conductor{0.5 * (microsurface.alpha[0] + microsurface.alpha[1]), {}};
    for (std::size_t channel = 0; channel < 3; ++channel)
        conductor.eta[channel] = std::complex{base.eta[channel], base.kappa[channel]} / ior_above;
    return conductor;
}

}  // namespace

double StackInterface::t_down(double cos_theta) const {
    // The tables are as far off as smooth interfaces need not be.
    if (alpha < kMinAlpha) return 1.0 - fresnel(cos_theta, ior_below / ior_above);
    return std::clamp(from_above.at(cos_theta), 0.0, 1.0);
}

double StackInterface::t_up(double cos_theta) const {
    if (alpha < kMinAlpha) return 1.0 - fresnel(cos_theta, ior_above / ior_below);
    return std::clamp(from_below.at(cos_theta), 0.0, 1.0);
}

Energy StackLayers::conductor_albedo(double cos_theta) const {
    Energy albedo{0.0};
    for (int channel = 0; channel < 3; ++channel) {
        const std::complex<double> eta = conductor->eta[static_cast<std::size_t>(channel)];
        albedo[channel] =
            conductor->alpha < kMinAlpha
                ? fresnel(cos_theta, eta)
                : tables->fgd_conductor(cos_theta, conductor->alpha, eta.real(), eta.imag());
    }
    return albedo;
}

StackLayers prepare_layers(const Material& material, const EnergyTables& tables) {
    if (material.layers.empty()) refuse(material, "/layers", "no layer");
    StackLayers layers{{}, {}, {}, &tables};
    double above = material.exterior_ior;
    for (std::size_t n = 0; n < material.layers.size(); ++n) {
        const Layer& layer = material.layers[n];
        const std::string pointer = fmt::format("/layers/{}", n);
        layers.interfaces.push_back(
            prepare_interface(uniform(material, layer.interface.roughness, pointer + "/interface"),
                              above, layer.interface.ior, tables));
        layers.tau.push_back(transmittance(material, layer.medium, pointer + "/medium"));
        above = layer.interface.ior;
    }
    if (std::holds_alternative<DiffuseFacetsBase>(material.base))
        refuse(material, "/base", "of diffuse facets");
    if (const auto* base = std::get_if<ConductorBase>(&material.base))
        layers.conductor =
            prepare_conductor(*base, uniform(material, base->roughness, "/base"), above);
    return layers;
}

}  // namespace lacquer::reference
