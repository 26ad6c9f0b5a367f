// The GGX (Trowbridge-Reitz) distribution at roughness 1.
// Based on: Heitz 2014, Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace lacquer::reference::ggx {

// See facets.h for what each computes.
double slope_density(double slope);
double lambda(double a);  // Heitz 2014, Eq. 72; a = cot(theta) > 0
glm::dvec3 sample_visible_normal(const glm::dvec3& w, const glm::dvec2& u);

}  // namespace lacquer::reference::ggx
