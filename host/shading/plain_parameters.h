// What the model `plain` reads of a material: its top interface and its base.
#pragma once

#include "lacquer/material.h"

namespace lacquer {

// LqPlainSurface of shader_src/plain/surface.glsl in double, before clamping.
struct PlainParameters {
    enum class BaseKind { none = 0, lambertian = 1, conductor = 2 };

    Microsurface coat;
    double coat_eta = 0.0;  // ior of the top layer / exterior; 0 without layers
    BaseKind base_kind = BaseKind::none;
    Microsurface base_facets;
    Rgb albedo{};
    Rgb eta{}, kappa{};  // relative to the exterior
};

// Throws Error naming the material and the JSON pointer of a blended microsurface, which `plain`
// cannot shade. Diffuse facets are shaded as Lambertian; media do not attenuate.
PlainParameters plain_parameters(const Material& material);

}  // namespace lacquer
