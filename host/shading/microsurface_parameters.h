// What the models of one rough surface read of a material.
#pragma once

#include <vector>

#include "core/model.h"
#include "lacquer/material.h"

namespace lacquer {

// LqMicrosurfaceMaterial of shader_src/microsurface/rough_surface.glsl in double, before clamping.
struct MicrosurfaceParameters {
    struct Stratum {
        Microsurface microsurface;
        double weight = 1.0;
        Rgb eta{}, kappa{};  // of a conductor, relative to the exterior
    };

    Blend::Operator op = Blend::Operator::asymmetric;
    std::vector<Stratum> strata;  // from the top, at most kMaxStrata
    double eta = 0.0;             // of facets that refract: ior below / exterior; else 0
    Rgb optical_depth{};          // of the medium below, along the normal; infinite where opaque
};

// Throws Error naming the material and the JSON pointer of what `model` cannot shade.
MicrosurfaceParameters microsurface_parameters(const Material& material, Model model);

}  // namespace lacquer
