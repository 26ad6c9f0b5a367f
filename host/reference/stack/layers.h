// What a stack is made of, as light meets it: rough dielectric interfaces, absorbing media between
// them, and at the bottom a conductor or whatever takes the light that arrives there.
#pragma once

#include <array>
#include <complex>
#include <optional>
#include <vector>

#include "lacquer/material.h"
#include "reference/stack/beam.h"
#include "tables/energy_tables.h"

namespace lacquer::reference {

struct StackInterface {
    double alpha;                 // GGX roughness of its energies (equivalent_alpha.h)
    double ior_above, ior_below;  // absolute
    TransmissionProfile from_above, from_below;

    // The shares of light at cos_theta in [0, 1] that cross it, all orders of scattering.
    double t_down(double cos_theta) const;
    double t_up(double cos_theta) const;
};

struct StackConductor {
    double alpha;
    std::array<std::complex<double>, 3> eta;  // relative to the medium above it
};

struct StackLayers {
    std::vector<StackInterface> interfaces;  // from the top
    std::vector<Energy> tau;                 // of the medium below each
    std::optional<StackConductor> conductor;
    const EnergyTables* tables;

    // What the conductor reflects of light at cos_theta in [0, 1], all orders of scattering.
    Energy conductor_albedo(double cos_theta) const;
};

// `tables` must outlive the result. Throws Error naming the JSON pointer of what a stack cannot be
// made of: no interface, a blended microsurface, a scattering medium, diffuse facets.
StackLayers prepare_layers(const Material& material, const EnergyTables& tables);

}  // namespace lacquer::reference
