// One rough surface with light on both sides, or on one: what the models of microsurfaces shade.
//
// Directions to the light and to the viewer may be on either side of a dielectric surface, whose
// medium has one boundary: crossing it absorbs. f is for radiance over the square of the index,
// which refraction keeps: f(wi, wo) / n(wi)^2 is symmetric, n(w) the index on the side of w.
#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "core/model.h"
#include "lacquer/material.h"
#include "reference/microsurface/single_scattering.h"

namespace lacquer::reference {

struct RoughSurface {
    RoughSide above;
    std::optional<RoughSide> below;  // of a dielectric surface
    glm::dvec3 tau{1.0};             // the medium's transmittance along the normal
    bool is_there = true;            // a surface between equal indices is not
};

// A dielectric interface as met from the exterior, of facets at least kMinAlpha rough.
RoughSide dielectric_side(const Interface& interface, double exterior_ior);

// Throws Error naming the JSON pointer of what `model` cannot shade: anything but one interface
// without a base or a bare conductor, diffuse strata, a medium that scatters.
RoughSurface rough_surface(const Material& material, Model model);

bool is_below(const glm::dvec3& w);

// A pair of directions in the frame of the side of wo.
struct Turned {
    const RoughSide* side = nullptr;  // nothing where there is no light
    glm::dvec3 wi, wo;
};

Turned turned(const RoughSurface& surface, const glm::dvec3& wi, const glm::dvec3& wo);

// What light along w leaves of itself to the medium below.
glm::dvec3 crossing(const RoughSurface& surface, const glm::dvec3& w);

}  // namespace lacquer::reference
