// Light that meets more than one facet of a rough surface, with which the closed form of light that
// met one is complete. How much that is follows from what the first facets leave over; where it
// goes is taken as diffuse, with m(w) the part of the directional albedo that met several facets:
//     f = m(wi) m(wo) / (pi m_average),
// which is reciprocal. What facets let through is a part of m that depends on the cosine, chosen so
// that it is reciprocal too.
// Based on: Kulla and Conty 2017, Revisiting Physically Based Shading at Imageworks (the lobe)
//
// Energies against random walks: see README. Directions are above their side.
#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "reference/microsurface/albedo_fit.h"
#include "reference/microsurface/rough_surface.h"

namespace lacquer::reference {

// m is known in the planes of x and y; between them it turns from one to the other, and the sooner
// the closer to grazing.
struct Turning {
    bool is_rougher_along_x = true;
    double alpha2_ratio = 1.0;    // of the lesser roughness to the greater, squared
    double beckmann_share = 0.0;  // of the surface
};

// Of light from one side.
struct SeveralFacetsSide {
    AlbedoFit in_xz, in_yz;             // m
    double through_at_grazing = 0.0;    // part of m that is let through,
    double through_slope = 0.0;         // and what it grows by per cosine
    glm::dvec3 average_reflected{0.0};  // over cosine-weighted directions
    double average_through = 0.0;
};

struct SeveralFacets {
    Turning turning;
    SeveralFacetsSide above, below;  // `below` of facets that refract
};

SeveralFacets several_facets(const RoughSurface& surface);

// The parts of light from w that are reflected and let through after several facets. Their sum is
// in [0, 1].
struct SeveralShares {
    glm::dvec3 reflected{0.0};
    double through = 0.0;
};
SeveralShares several_shares(const Turning& turning, const SeveralFacetsSide& side,
                             const glm::dvec3& w);

// f from one direction to another of the same side, with their shares.
glm::dvec3 several_reflected(const SeveralFacetsSide& side, const SeveralShares& from,
                             const SeveralShares& to);

// f for light that comes from the far side, for radiance over the square of the index.
double several_through(const SeveralFacetsSide& far_side, const SeveralShares& from,
                       const SeveralShares& to);

}  // namespace lacquer::reference
