// What a stack is made of, as light meets it: rough dielectric interfaces, media between them, and
// at the bottom a conductor or whatever takes the light that arrives there.
#pragma once

#include <array>
#include <complex>
#include <optional>
#include <vector>

#include "lacquer/material.h"
#include "reference/microsurface/facet_strata.h"
#include "reference/stack/beam.h"
#include "reference/stack/scattering.h"
#include "tables/energy_tables.h"

namespace lacquer::reference {

// What the facets of one stratum would make of a whole interface.
struct InterfaceStratum {
    double alpha;       // GGX roughness of its energies (equivalent_alpha.h)
    double lobe_alpha;  // and of its lobes (equivalent_lobe_alpha.h)
    DirectionPolynomial from_above, from_below;
};

// Of one stratum where it is uniform. Of several, each takes part in what the interface does by the
// light that meets its first facet there (blended_energies.h).
struct StackInterface {
    FacetStrata facets;  // for first_met alone
    std::vector<InterfaceStratum> strata;
    double ior_above, ior_below;           // absolute
    DirectionPolynomial entering_blend{};  // of several strata

    // The index of the medium that light enters over that of its own.
    double eta(bool downwards) const;

    // The parts of light at `cosine` in [0, 1] that meet the strata first.
    StratumShares first_met(double cosine, bool downwards) const;

    // The share of that light that crosses it, all orders of scattering, were all of one stratum.
    double transmittance(const InterfaceStratum& stratum, double cosine, bool downwards) const;

    // Of light from above that crosses it: of several strata by a polynomial of direction.
    double entering(double cosine) const;

    // Energies' roughness of the roughest stratum.
    double greatest_alpha() const;
};

struct StackMedium {
    Energy absorption{0.0};  // optical depth along the normal
    // Of a medium that scatters: red, green, blue, and without absorption.
    std::optional<std::array<ScatteringSlab, 4>> slabs{};

    // What one that only absorbs lets through at `cosine`.
    Energy transmittance(double cosine) const;
};

// What the facets of one stratum would make of a whole conductor.
struct ConductorStratum {
    double alpha;                             // of its energies
    double lobe_alpha;                        // see InterfaceStratum
    std::array<std::complex<double>, 3> eta;  // relative to the medium above it
    std::array<DirectionPolynomial, 3> fgd;

    // What it reflects of light at `cosine`, all orders of scattering, for a lobe about `mean`: of
    // a smooth one the polynomials know the differences between directions better than the values.
    Energy albedo(double cosine, double mean) const;
};

// See StackInterface.
struct StackConductor {
    FacetStrata facets;
    std::vector<ConductorStratum> strata;

    StratumShares first_met(double cosine) const;
};

struct StackLayers {
    std::vector<StackInterface> interfaces;  // from the top
    std::vector<StackMedium> media;          // below each
    std::optional<StackConductor> conductor;
    const EnergyTables* tables;
    bool open_below = false;  // no base: light leaves there

    std::size_t count() const { return interfaces.size(); }
};

// `tables` must outlive the result. Throws Error naming the JSON pointer of what a stack cannot be
// made of: no interface, diffuse facets, diffuse strata.
StackLayers prepare_layers(const Material& material, const EnergyTables& tables);

}  // namespace lacquer::reference
