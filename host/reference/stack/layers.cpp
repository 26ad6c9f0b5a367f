#include "reference/stack/layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/exponential.hpp>
#include <string>

#include "core/error.h"
#include "reference/equivalent_alpha.h"
#include "reference/fresnel.h"
#include "reference/shading.h"
#include "reference/stack/equivalent_lobe_alpha.h"

namespace lacquer::reference {

namespace {

// The largest indices of conductors that the tables hold.
constexpr double kMaxTableIndex = 5.0, kMaxTableKappa = 10.0;

[[noreturn]] void refuse(const Material& material, const std::string& pointer,
                         const std::string& found) {
    throw Error{
        fmt::format("material '{}': {}: {}; stacks have uniform microsurfaces and media over a"
                    " conductor, a Lambertian base or none",
                    material.name, pointer, found)};
}

const Microsurface& uniform(const Material& material, const Roughness& roughness,
                            const std::string& pointer) {
    const auto* microsurface = std::get_if<Microsurface>(&roughness);
    if (!microsurface) refuse(material, pointer + "/blend", "the microsurface is blended");
    return *microsurface;
}

// Of light that a black medium would let through.
constexpr double kMaxDepth = 80.0;

StackMedium prepare_medium(const Medium& medium) {
    StackMedium prepared;
    const auto* absorbing = std::get_if<AbsorbingMedium>(&medium);
    const auto* slab = std::get_if<ScatteringMedium>(&medium);
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const double depth = absorbing ? -std::log(absorbing->tau[channel])
                                       : slab->sigma_a[channel] * slab->thickness;
        prepared.absorption[static_cast<int>(channel)] = std::min(depth, kMaxDepth);
    }
    if (!slab || slab->sigma_s == Rgb{} || slab->thickness <= 0.0) return prepared;
    prepared.slabs.emplace();
    ScatteringSlab& clear = prepared.slabs->back();
    clear.g = slab->g;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        (*prepared.slabs)[channel] = scattering_slab(*slab, channel);
        clear.scattering += (*prepared.slabs)[channel].scattering / 3.0;
    }
    return prepared;
}

StackInterface prepare_interface(const Microsurface& microsurface, double above, double below,
                                 const EnergyTables& tables) {
    const double eta = below / above;
    const double alpha = equivalent_ggx_alpha(microsurface, eta);
    return {alpha, equivalent_lobe_alpha(microsurface), above,
            below, tables.clear_profile(alpha, eta),    tables.clear_profile(alpha, 1.0 / eta)};
}

// An isotropic roughness for an anisotropic one: the mean, as equivalent_alpha.h has it.
StackConductor prepare_conductor(const ConductorBase& base, const Microsurface& microsurface,
                                 double ior_above, const EnergyTables& tables) {
    StackConductor conductor{0.5 * (microsurface.alpha[0] + microsurface.alpha[1]),
                             equivalent_lobe_alpha(microsurface),
                             {},
                             {}};
    for (std::size_t channel = 0; channel < 3; ++channel) {
        conductor.eta[channel] = std::complex{base.eta[channel], base.kappa[channel]} / ior_above;
        conductor.fgd[channel] = tables.fgd_conductor_profile(
            conductor.alpha, std::min(conductor.eta[channel].real(), kMaxTableIndex),
            std::min(conductor.eta[channel].imag(), kMaxTableKappa));
    }
    return conductor;
}

}  // namespace

double StackInterface::eta(bool downwards) const {
    return downwards ? ior_below / ior_above : ior_above / ior_below;
}

double StackInterface::transmittance(double cosine, bool downwards) const {
    // The tables are as far off as smooth interfaces need not be.
    if (alpha < kMinAlpha) return 1.0 - fresnel(cosine, eta(downwards));
    return std::clamp((downwards ? from_above : from_below).at(cosine), 0.0, 1.0);
}

Energy StackMedium::transmittance(double cosine) const {
    return glm::exp(-absorption / std::max(cosine, 1e-3));
}

Energy StackConductor::albedo(double cosine, double mean) const {
    Energy reflected{0.0};
    for (int channel = 0; channel < 3; ++channel) {
        const auto c = static_cast<std::size_t>(channel);
        const double correction = alpha < kMinAlpha ? fresnel(mean, eta[c]) - fgd[c].at(mean) : 0.0;
        reflected[channel] = std::clamp(fgd[c].at(cosine) + correction, 0.0, 1.0);
    }
    return reflected;
}

StackLayers prepare_layers(const Material& material, const EnergyTables& tables) {
    if (material.layers.empty()) refuse(material, "/layers", "there is none");
    StackLayers layers{{}, {}, {}, &tables, std::holds_alternative<NoBase>(material.base)};
    double above = material.exterior_ior;
    for (std::size_t n = 0; n < material.layers.size(); ++n) {
        const Layer& layer = material.layers[n];
        const std::string pointer = fmt::format("/layers/{}", n);
        layers.interfaces.push_back(
            prepare_interface(uniform(material, layer.interface.roughness, pointer + "/interface"),
                              above, layer.interface.ior, tables));
        layers.media.push_back(prepare_medium(layer.medium));
        above = layer.interface.ior;
    }
    if (std::holds_alternative<DiffuseFacetsBase>(material.base))
        refuse(material, "/base", "it is made of diffuse facets");
    if (const auto* base = std::get_if<ConductorBase>(&material.base))
        layers.conductor =
            prepare_conductor(*base, uniform(material, base->roughness, "/base"), above, tables);
    return layers;
}

}  // namespace lacquer::reference
