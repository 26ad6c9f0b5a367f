// What the model `stack` reads of a material: every layer and the base.
#pragma once

#include <array>
#include <vector>

#include "core/model.h"
#include "lacquer/material.h"

namespace lacquer {

// LqStackMaterial of shader_src/stack/material.glsl in double, before clamping.
struct StackParameters {
    struct Facets {
        Microsurface microsurface;
        double weight = 1.0;
    };
    struct Layer {
        Blend::Operator op = Blend::Operator::asymmetric;
        std::vector<Facets> strata;  // from the top, one of a uniform interface
        double index = 1.0;          // below the interface, over the exterior's
        Rgb absorption{};            // optical depth along the normal; infinite where it is opaque
        Rgb scattering{};            // optical depth along the normal
        double g = 0.0;              // mean cosine of the phase function
    };
    enum class BaseKind { none = 0, lambertian = 1, conductor = 2 };

    std::vector<Layer> layers;  // from the top
    BaseKind base_kind = BaseKind::none;
    Microsurface base_facets;
    Rgb albedo{};
    Rgb eta{}, kappa{};  // relative to the exterior
};

// The rows that LqStackMaterial describes: of every layer, and then of the strata of blends.
std::vector<std::array<double, 4>> layer_rows(const StackParameters& stack);

// Throws Error naming the material and the JSON pointer of what `model` cannot shade.
StackParameters stack_parameters(const Material& material, Model model);

}  // namespace lacquer
