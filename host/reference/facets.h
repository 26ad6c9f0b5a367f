// A rough interface as a distribution of facet normals with Smith masking, height-correlated, in
// the form of the textbooks. Directions are local (z = normal), and above the surface. Based on:
// Walter et al. 2007, Microfacet Models for Refraction through Rough Surfaces;
//           Heitz 2014, Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lacquer/material.h"

namespace lacquer::reference {

struct Facets {
    Ndf ndf = Ndf::ggx;
    double alpha_x = 1.0;  // slope roughness along x, > 0
    double alpha_y = 1.0;
};

// The distribution of facet slopes (-wm.x / wm.z, -wm.y / wm.z) where both roughnesses are 1, at a
// distance `slope` from slope 0. Its integral over the plane is 1.
double slope_density(Ndf ndf, double slope);

// D(wm), per solid angle.
double density(const Facets& facets, const glm::dvec3& wm);

// Smith's Lambda(w): the ratio of hidden to visible area.
double lambda(const Facets& facets, const glm::dvec3& w);

// G1(w), the visible fraction of the area that faces w.
double masking(const Facets& facets, const glm::dvec3& w);

// G2(wi, wo), the fraction that both see. Heitz 2014, Eq. 99.
double masking_shadowing(const Facets& facets, const glm::dvec3& wi, const glm::dvec3& wo);

// D_w(wm), the density per solid angle of the normals visible from w. Heitz 2014, Eq. 16.
double visible_density(const Facets& facets, const glm::dvec3& w, const glm::dvec3& wm);

// A normal of that density, from two numbers in [0, 1). GGX: Dupuy and Benyoub 2023, Sampling
// Visible GGX Normals with Spherical Caps. Beckmann: by inverting the distribution functions of the
// slope along w and of the slope across it (Jakob 2014, An Improved Visible Normal Sampling Routine
// for the Beckmann Distribution). At normal incidence "along" is x.
glm::dvec3 sample_visible_normal(const Facets& facets, const glm::dvec3& w, const glm::dvec2& u);

}  // namespace lacquer::reference
