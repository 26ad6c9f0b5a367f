// The model `microsurface-compensated` in double precision: one rough surface, uniform or not, with
// all the light that its facets send on. What met one facet is in closed form as in
// `microsurface-single`, what met several diffuse as in several_facets.h.
#pragma once

#include <glm/vec3.hpp>

#include "lacquer/material.h"
#include "reference/microsurface/microsurface_single.h"
#include "reference/microsurface/several_facets.h"
#include "reference/shading.h"

namespace lacquer::reference {

struct CompensatedMicrosurface {
    SingleMicrosurface single;
    SeveralFacets several;
    // Of light that several facets send down, reflected from below or let through from above: what
    // the medium below leaves of it.
    glm::dvec3 crossed_reflected{1.0}, crossed_through{1.0};
};

// Throws Error as rough_surface does.
CompensatedMicrosurface prepare_microsurface_compensated(const Material& material);

// f(wi, wo), per steradian, of reflection or, with the directions on both sides, of refraction; 0
// along the surface and between equal indices, where light goes straight on.
glm::dvec3 eval(const CompensatedMicrosurface& surface, const glm::dvec3& wi, const glm::dvec3& wo);

// Density per solid angle with which `sample` chooses wi.
double pdf(const CompensatedMicrosurface& surface, const glm::dvec3& wi, const glm::dvec3& wo);

// A direction of light for a viewer at wo, from u in [0, 1)^3: u.x chooses between a
// cosine-weighted direction on either side, by what is reflected and let through there after
// several facets, and the first facet, as in `microsurface-single`; (u.y, u.z) the direction or the
// facet.
Sample sample(const CompensatedMicrosurface& surface, const glm::dvec3& wo, const glm::dvec3& u);

// The fractions of light along wo that leave on the side of wo (`direct`, of a conductor `base`)
// and on the other (`transmitted`), to 1e-6 of what `eval` sends.
Albedo albedo(const CompensatedMicrosurface& surface, const glm::dvec3& wo);

}  // namespace lacquer::reference
