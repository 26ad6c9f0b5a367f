// A uniform population of facets: how opaque it is to a direction, and which facet a ray meets.
// Based on: Heitz et al. 2016, Multiple-Scattering Microfacet BSDFs with the Smith Model
//
// Every function serves directions to both sides, and alpha 0, where all facets lie flat.
#pragma once

#include "lacquer/material.h"
#include "simulator/random.h"
#include "simulator/sampling.h"

namespace lacquer::simulator {

// Facet normals of one distribution; alphas in [0, 1].
struct Facets {
    Ndf ndf = Ndf::ggx;
    double alpha_x = 0.0, alpha_y = 0.0;
};

// Smith's Lambda for any direction, with Lambda(-w) = -1 - Lambda(w): at least 0 upwards and along
// the plane, at most -1 downwards. Always finite.
double smith_lambda(const Facets& facets, const Vec3& w);

// Area of facets facing w per unit of macroscopic area.
double projected_area(const Facets& facets, const Vec3& w);

// Area of facets per unit of macroscopic area and solid angle of their normal wm, the distribution
// D of the facets; both alphas above 0.
double normal_density(const Facets& facets, const Vec3& wm);

// Normal (upper hemisphere) of a facet met by a ray that comes from w: density proportional to
// max(0, dot(w, wm)) D(wm).
Vec3 sample_visible_normal(const Facets& facets, const Vec3& w, RandomStream& random);

}  // namespace lacquer::simulator
