#include "reference/stack/layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/exponential.hpp>
#include <string>

#include "core/error.h"
#include "reference/blended_energies.h"
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
    throw Error{fmt::format(
        "material '{}': {}: {}; stacks have rough interfaces and media over a conductor,"
        " a Lambertian base or none",
        material.name, pointer, found)};
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

StackInterface prepare_interface(const Roughness& roughness, double above, double below,
                                 const EnergyTables& tables) {
    const Blend blend = strata_of(roughness);
    const double eta = below / above;
    StackInterface interface { {}, {}, above, below };
    std::vector<double> alphas;
    for (const Stratum& stratum : blend.strata) {
        const double alpha = equivalent_ggx_alpha(stratum.microsurface, eta);
        alphas.push_back(alpha);
        interface.strata.push_back({alpha, equivalent_lobe_alpha(stratum.microsurface),
                                    tables.clear_profile(alpha, eta),
                                    tables.clear_profile(alpha, 1.0 / eta)});
    }
    interface.facets = isotropic_strata(blend, alphas);
    if (blend.strata.size() > 1)
        interface.entering_blend =
            blended(interface.facets, std::sqrt(std::max(1.0 - eta * eta, 0.0)),
                    [&](std::size_t k, double cosine) {
                        return interface.transmittance(interface.strata[k], cosine, true);
                    });
    return interface;
}

// An isotropic roughness for an anisotropic one: the mean, as equivalent_alpha.h has it.
StackConductor prepare_conductor(const ConductorBase& base, double ior_above,
                                 const EnergyTables& tables) {
    const Blend blend = strata_of(base.roughness);
    StackConductor conductor;
    std::vector<double> alphas;
    for (const Stratum& stratum : blend.strata) {
        const Microsurface& microsurface = stratum.microsurface;
        const Rgb eta = stratum.eta.value_or(base.eta), kappa = stratum.kappa.value_or(base.kappa);
        ConductorStratum prepared{0.5 * (microsurface.alpha[0] + microsurface.alpha[1]),
                                  equivalent_lobe_alpha(microsurface),
                                  {},
                                  {}};
        for (std::size_t channel = 0; channel < 3; ++channel) {
            prepared.eta[channel] = std::complex{eta[channel], kappa[channel]} / ior_above;
            prepared.fgd[channel] = tables.fgd_conductor_profile(
                prepared.alpha, std::min(prepared.eta[channel].real(), kMaxTableIndex),
                std::min(prepared.eta[channel].imag(), kMaxTableKappa));
        }
        alphas.push_back(prepared.alpha);
        conductor.strata.push_back(prepared);
    }
    conductor.facets = isotropic_strata(blend, alphas);
    return conductor;
}

}  // namespace

double StackInterface::eta(bool downwards) const {
    return downwards ? ior_below / ior_above : ior_above / ior_below;
}

StratumShares StackInterface::first_met(double cosine, bool downwards) const {
    return downwards ? first_met_at(facets, cosine) : first_met_from_below(facets, cosine);
}

double StackInterface::transmittance(const InterfaceStratum& stratum, double cosine,
                                     bool downwards) const {
    // The tables are as far off as smooth interfaces need not be.
    if (stratum.alpha < kMinAlpha) return 1.0 - fresnel(cosine, eta(downwards));
    return std::clamp((downwards ? stratum.from_above : stratum.from_below).at(cosine), 0.0, 1.0);
}

double StackInterface::entering(double cosine) const {
    if (strata.size() == 1 || greatest_alpha() < kMinAlpha)
        return transmittance(strata.front(), cosine, true);
    return std::clamp(entering_blend.at(cosine), 0.0, 1.0);
}

double StackInterface::greatest_alpha() const {
    return std::ranges::max(strata, {}, &InterfaceStratum::alpha).alpha;
}

Energy StackMedium::transmittance(double cosine) const {
    return glm::exp(-absorption / std::max(cosine, 1e-3));
}

Energy ConductorStratum::albedo(double cosine, double mean) const {
    Energy reflected{0.0};
    for (int channel = 0; channel < 3; ++channel) {
        const auto c = static_cast<std::size_t>(channel);
        const double correction = alpha < kMinAlpha ? fresnel(mean, eta[c]) - fgd[c].at(mean) : 0.0;
        reflected[channel] = std::clamp(fgd[c].at(cosine) + correction, 0.0, 1.0);
    }
    return reflected;
}

StratumShares StackConductor::first_met(double cosine) const {
    return first_met_at(facets, cosine);
}

StackLayers prepare_layers(const Material& material, const EnergyTables& tables) {
    if (material.layers.empty()) refuse(material, "/layers", "there is none");
    StackLayers layers{{}, {}, {}, &tables, std::holds_alternative<NoBase>(material.base)};
    double above = material.exterior_ior;
    for (std::size_t n = 0; n < material.layers.size(); ++n) {
        const Layer& layer = material.layers[n];
        layers.interfaces.push_back(
            prepare_interface(layer.interface.roughness, above, layer.interface.ior, tables));
        layers.media.push_back(prepare_medium(layer.medium));
        above = layer.interface.ior;
    }
    if (std::holds_alternative<DiffuseFacetsBase>(material.base))
        refuse(material, "/base", "it is made of diffuse facets");
    if (const auto* base = std::get_if<ConductorBase>(&material.base)) {
        const Blend blend = strata_of(base->roughness);
        for (std::size_t k = 0; k < blend.strata.size(); ++k)
            if (blend.strata[k].albedo)
                refuse(material, fmt::format("/base/conductor/blend/strata/{}/albedo", k),
                       "it is made of diffuse facets");
        layers.conductor = prepare_conductor(*base, above, tables);
    }
    return layers;
}

}  // namespace lacquer::reference
