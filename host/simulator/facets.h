// A uniform population of facets: how opaque it is to a direction, and which facet a ray meets.
// Based on: Heitz et al. 2016, Multiple-Scattering Microfacet BSDFs with the Smith Model
#pragma once

#include <glm/vec3.hpp>

#include "lacquer/material.h"
#include "simulator/random.h"

namespace lacquer::simulator {

using Vec3 = glm::dvec3;

// Facet normals of one distribution; alphas in [0, 1]. Both alphas 0: one flat facet.
struct Facets {
    Ndf ndf = Ndf::ggx;
    double alpha_x = 0.0, alpha_y = 0.0;

    bool smooth() const { return alpha_x <= 0.0 && alpha_y <= 0.0; }
};

// Smith's Lambda of a rough population for any direction, with Lambda(-w) = -1 - Lambda(w):
// positive upwards, at most -1 downwards.
double smith_lambda(const Facets& facets, const Vec3& w);

// Area of facets facing w per unit of macroscopic area, w to either side.
double projected_area(const Facets& facets, const Vec3& w);

// Normal (upper hemisphere) of a facet of a rough population met by a ray that comes from w, w to
// either side: density proportional to max(0, dot(w, wm)) D(wm).
Vec3 sample_visible_normal(const Facets& facets, const Vec3& w, RandomStream& random);

}  // namespace lacquer::simulator
