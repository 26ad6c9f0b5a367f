// A few of the facets that a direction sees, chosen and weighted so that sums over them are
// integrals over all: a quadrature small enough to be done while a surface is prepared.
//
// The direction w is above the surface and in its xz or yz plane, about which facets are symmetric:
// only one half of them is looked at.
#pragma once

#include <functional>
#include <glm/vec3.hpp>

#include "reference/facets.h"

namespace lacquer::reference {

// A facet and its part of the integral over wm of D(wm) dot(w, wm) / cos_theta.
struct FacetPoint {
    glm::dvec3 wm;
    double cos_theta;  // dot(w, wm), > 0
    double weight;
};

using AtFacetPoint = std::function<void(const FacetPoint& point)>;

// Facets that mirror w to above the surface.
void for_facets_mirroring_up(const Facets& facets, const glm::dvec3& w, const AtFacetPoint& at);

// Those that mirror it down, to other facets.
void for_facets_mirroring_down(const Facets& facets, const glm::dvec3& w, const AtFacetPoint& at);

// Those that w meets below the critical angle, of the cosine given: there may be none.
void for_facets_within(const Facets& facets, const glm::dvec3& w, double critical_cosine,
                       const AtFacetPoint& at);

}  // namespace lacquer::reference
