// Rough surfaces that tests share.
#pragma once

#include <cmath>
#include <vector>

#include "simulator/microsurface.h"

namespace lacquer::heightfield::test {

// Reflects all light: of a purely imaginary index.
inline const simulator::ConductorFacet kMirror{{0, 0, 0}, {1, 1, 1}};

inline simulator::Facets beckmann(double alpha_x, double alpha_y) {
    return {Ndf::beckmann, alpha_x, alpha_y};
}

inline simulator::Facets beckmann(double alpha) {
    return beckmann(alpha, alpha);
}

inline std::vector<simulator::FacetStratum> uniform(
    double alpha, const simulator::FacetMaterial& material = kMirror) {
    return {{1.0, beckmann(alpha), material}};
}

inline std::vector<simulator::FacetStratum> two_strata(
    double top, double bottom, const simulator::FacetMaterial& material = kMirror) {
    return {{0.5, beckmann(top), material}, {0.5, beckmann(bottom), material}};
}

// Towards light at `theta` from the normal, in radians.
inline simulator::Vec3 direction_at(double theta) {
    return {std::sin(theta), 0.0, std::cos(theta)};
}

}  // namespace lacquer::heightfield::test
