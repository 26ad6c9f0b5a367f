// Integrals over the facets that face a direction.
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "reference/facets.h"

namespace lacquer::reference {

// Tilts in radians, from the normal of the surface, of facets that tilt towards one azimuth, in
// rising order: f is smooth between two of them, but may begin or end like a square root, and is 0
// outside of all.
using TiltBreaks = std::function<std::vector<double>(const glm::dvec2& azimuth)>;

// The integral over wm of
//     D(wm) dot(wo, wm) / cos_theta_o f(wm, dot(wo, wm)),
// wo above the surface, by adaptive quadrature, to 1e-6 of the whole.
double facet_integral(const Facets& facets, const glm::dvec3& wo, const TiltBreaks& breaks,
                      const std::function<double(const glm::dvec3& wm, double cos_theta)>& f);

// Breaks of what facets reflect to above the surface, `eta` as in refraction.h or, of conductors,
// above 1: nothing more happens beyond the horizon, and total reflection begins with a root.
std::vector<double> reflecting_tilts(const glm::dvec3& wo, const glm::dvec2& azimuth, double eta);

// Breaks of what facets refract to below the surface; none where no facet does.
std::vector<double> refracting_tilts(const glm::dvec3& wo, const glm::dvec2& azimuth, double eta);

}  // namespace lacquer::reference
