// What the models of one coat read of a material: its top layer and its base.
#pragma once

#include "core/model.h"
#include "lacquer/material.h"

namespace lacquer {

// LqOneCoat of shader_src/one_coat/surface.glsl in double, before clamping.
struct OneCoatParameters {
    enum class BaseKind { none = 0, lambertian = 1, conductor = 2 };

    Microsurface coat;
    double coat_eta = 0.0;  // ior of the top layer / exterior; 0 without layers
    Rgb optical_depth{};    // of the top layer along the normal; infinite where it is opaque
    BaseKind base_kind = BaseKind::none;
    Microsurface base_facets;
    Rgb albedo{};
    Rgb eta{}, kappa{};  // relative to the exterior
};

// exp(-optical_depth): what the top layer transmits along the normal.
Rgb transmittance(const OneCoatParameters& parameters);

// Throws Error naming the material and the JSON pointer of a feature that `model`, one of those of
// one coat, cannot shade. Diffuse facets are shaded as Lambertian.
OneCoatParameters one_coat_parameters(const Material& material, Model model);

}  // namespace lacquer
