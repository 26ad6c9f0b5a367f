// The facets of a non-uniform surface that a direction sees.
// Based on: d'Eon et al. 2023, Microfacet Theory for Non-Uniform Heightfields
#pragma once

#include <glm/vec3.hpp>

#include "reference/microsurface/facet_strata.h"

namespace lacquer::reference {

// Density per solid angle of the normals visible from w; its integral is 1.
double visible_density(const FacetStrata& surface, const glm::dvec3& w, const glm::dvec3& wm);

struct VisibleNormal {
    std::size_t stratum;
    glm::dvec3 wm;
    double u;  // what is left of u.x: again in [0, 1)
};

// A normal of that density, from three numbers in [0, 1): u.x chooses a stratum by what of its
// facets' projected area is visible from w, (u.y, u.z) one of its visible normals. Symmetric: Eq.
// 10. Asymmetric: the stratum that a ray from w meets first, w_B^(1 + Lambda_A) of the rays passing
// a top stratum A (section 3.3.2, whose exponent lacks the division by cos_theta).
VisibleNormal sample_visible_normal(const FacetStrata& surface, const glm::dvec3& w,
                                    const glm::dvec3& u);

}  // namespace lacquer::reference
