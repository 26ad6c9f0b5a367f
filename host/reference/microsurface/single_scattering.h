// Light that met one facet of a non-uniform surface, in closed form.
// Based on: d'Eon et al. 2023, Microfacet Theory for Non-Uniform Heightfields
#pragma once

#include <array>
#include <complex>
#include <glm/vec3.hpp>
#include <vector>

#include "reference/microsurface/facet_strata.h"
#include "reference/shading.h"

namespace lacquer::reference {

// Index of what is behind a facet over that of what is before it, per colour channel.
using FacetIndex = std::array<std::complex<double>, 3>;

// A surface as it is met from one side; wo is above it. Facets that refract have one real index
// everywhere, and it is not 1.
struct RoughSide {
    FacetStrata facets;
    std::vector<FacetIndex> index;  // of each stratum
    bool refracts = false;
};

// The same from the other side; the facets refract.
RoughSide turned_over(const RoughSide& side);

// The index of facets that refract.
double eta_of(const RoughSide& side);

// A direction in the frame of the other side.
glm::dvec3 mirrored(const glm::dvec3& w);

// f of light reflected from wi, above. Eq. 15, of any number of strata.
glm::dvec3 reflected_once(const RoughSide& side, const glm::dvec3& wi, const glm::dvec3& wo);

// Light refracted from wi, below: the density per solid angle of the light that wo would send there
// (Eq. 21 with |cos_theta_i|), symmetric but for a factor eta^2 cos_theta_i / cos_theta_o.
double refracted_once(const RoughSide& side, const glm::dvec3& wi, const glm::dvec3& wo);

// Densities per solid angle of wi where wo is reflected or refracted by a visible normal, as its
// facet chooses; together their integral is at most 1, being 1 but for directions on the wrong side
// of the surface.
double reflected_pdf(const RoughSide& side, const glm::dvec3& wi, const glm::dvec3& wo);
double refracted_pdf(const RoughSide& side, const glm::dvec3& wi, const glm::dvec3& wo);

struct FacetSample {
    glm::dvec3 wi;
    bool refracted = false;
    bool is_lost = false;  // on the wrong side of the surface
};

// A direction of these densities, from u in [0, 1)^3 (visible_normals.h).
FacetSample sample_facet(const RoughSide& side, const glm::dvec3& wo, const glm::dvec3& u);

// Integrals over wi, to 1e-6 of the whole: the light from wo that is reflected, and that is
// refracted, and then crosses a medium of transmittance `tau` along the normal.
glm::dvec3 reflected_share(const RoughSide& side, const glm::dvec3& wo, const glm::dvec3& tau);
glm::dvec3 refracted_share(const RoughSide& side, const glm::dvec3& wo, const glm::dvec3& tau);

}  // namespace lacquer::reference
