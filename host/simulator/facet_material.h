// What one facet does to a ray that meets it.
#pragma once

#include <variant>

#include "lacquer/material.h"
#include "simulator/random.h"
#include "simulator/sampling.h"

namespace lacquer::simulator {

// Refracts or reflects; `eta` = ior below / ior above.
struct DielectricFacet {
    double eta = 1.5;
};

// Reflects or absorbs; index eta + i kappa per channel, relative to the medium above.
struct ConductorFacet {
    Rgb eta{}, kappa{};
};

// Reflects diffusely or absorbs, about its own normal.
struct DiffuseFacet {
    Rgb albedo{};
};

using FacetMaterial = std::variant<DielectricFacet, ConductorFacet, DiffuseFacet>;

// Fresnel reflectance of a smooth dielectric boundary, cos_theta_i in [0, 1]; 1 beyond the critical
// angle.
double dielectric_reflectance(double cos_theta_i, double eta);

// Fresnel reflectance of a smooth conductor, cos_theta_i in [0, 1].
double conductor_reflectance(double cos_theta_i, double eta, double kappa);

// The same per channel.
Vec3 conductor_reflectance(double cos_theta_i, const ConductorFacet& facet);

// Where a ray goes after a facet. `direction` is where it travels; `weight` multiplies what it
// carries; `refracted` when it is on the other side of the facet now.
struct FacetEvent {
    Vec3 direction;
    Vec3 weight;
    bool refracted = false;
};

// A ray that travels along `direction` meets a facet of normal `wm` (dot(direction, wm) < 0).
// Reflection or refraction is chosen at random by the reflectance, so that weights stay 1.
FacetEvent meet_facet(const FacetMaterial& material, const Vec3& direction, const Vec3& wm,
                      RandomStream& random);

}  // namespace lacquer::simulator
