// Light reflected once by the facets of a rough interface, without and with Fresnel's factor.
// Based on: Walter et al. 2007, Microfacet Models for Refraction through Rough Surfaces
#pragma once

#include <complex>
#include <functional>

#include "reference/facets.h"

namespace lacquer::reference {

// The normal that mirrors wo into wi.
glm::dvec3 halfway(const glm::dvec3& wi, const glm::dvec3& wo);

// Cosine between the halfway normal and either direction: the mean of both, which is the same under
// exchange even for directions rounded to float.
double cos_theta_halfway(const glm::dvec3& wi, const glm::dvec3& wo);

// D G2 / (4 cos_theta_i cos_theta_o). Walter et al. 2007, Eq. 20 without F.
double reflection_lobe(const Facets& facets, const glm::dvec3& wi, const glm::dvec3& wo);

// Density of wi where it is wo mirrored by a visible normal.
double reflection_pdf(const Facets& facets, const glm::dvec3& wi, const glm::dvec3& wo);

// wo mirrored by a visible normal; it may point below the surface.
glm::dvec3 reflection_sample(const Facets& facets, const glm::dvec3& wo, const glm::dvec2& u);

// The integral over wi above the surface of reflection_lobe(wi, wo) factor(wi) cos_theta_i. By
// adaptive quadrature, to 1e-7 for a smooth factor.
using Factor = std::function<double(const glm::dvec3& wi)>;
double reflection_integral(const Facets& facets, const glm::dvec3& wo, const Factor& factor);

// The same of a Lambertian lobe, 1 / pi. The azimuth is counted from wo's.
double cosine_integral(const glm::dvec3& wo, const Factor& factor);

// Directional albedo of the lobe with the Fresnel factor of `eta`: the integral over wi above the
// surface of F D G2 / (4 cos_theta_o), to 1e-7.
double reflection_albedo(const Facets& facets, std::complex<double> eta, const glm::dvec3& wo);

}  // namespace lacquer::reference
