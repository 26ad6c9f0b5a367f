// The figures of Belcour 2018, Efficient Rendering of Layered Materials using an Atomic
// Decomposition with Statistical Operators, and figure 10 of de Dinechin and Belcour 2022: stacks
// of layers.
#pragma once

#include <array>

#include "study/suite.h"

namespace lacquer::study {

Figure reflection_operator_figure(const StudyRun& run);
Figure refraction_operator_figure(const StudyRun& run);
Figure medium_operators_figure(const StudyRun& run);
Figure mixed_facets_figure(const StudyRun& run);
Figure saturation_figure(const StudyRun& run);
Figure stack_furnace_figure(const StudyRun& run);
Figure frosted_metal_figure(const StudyRun& run);
Figure scattering_film_figure(const StudyRun& run);
Figure plates_figure(const StudyRun& run);
Figure smooth_coat_figure(const StudyRun& run);
Figure equal_roughness_figure(const StudyRun& run);
Figure variance_figure(const StudyRun& run);
Figure two_layer_grid_figure(const StudyRun& run);
Figure coated_coats_figure(const StudyRun& run);
Figure diffuse_algorithm_figure(const StudyRun& run);
Figure validity_map_figure(const StudyRun& run);
Figure random_stacks_figure(const StudyRun& run);
Figure bundled_materials_figure(const StudyRun& run);

inline constexpr std::array<FigureEntry, 18> kLayeredFigures{{
    {"figure-4", reflection_operator_figure},
    {"figure-7", refraction_operator_figure},
    {"figure-8", medium_operators_figure},
    {"beckmann", mixed_facets_figure},
    {"figure-11", saturation_figure},
    {"figure-12", stack_furnace_figure},
    {"figure-13", frosted_metal_figure},
    {"figure-14", scattering_film_figure},
    {"figure-15", plates_figure},
    {"figure-17", smooth_coat_figure},
    {"figure-19", equal_roughness_figure},
    {"figure-21", variance_figure},
    {"figure-22", two_layer_grid_figure},
    {"figure-10-of-2022", coated_coats_figure},
    {"algorithm-1-of-2022", diffuse_algorithm_figure},
    {"validity-map", validity_map_figure},
    {"random-stacks", random_stacks_figure},
    {"bundled-materials", bundled_materials_figure},
}};

inline constexpr Suite kLayered{
    "layered", "Stacks of layers",
    "The figures of Belcour 2018, Efficient Rendering of Layered Materials using an Atomic "
    "Decomposition with Statistical Operators, and figure 10 of de Dinechin and Belcour 2022, "
    "simulated again",
    "stack is this project's model of any number of layers; weidlich-wilkie, clearcoat and plain "
    "are what it is measured against. The first two shade one layer; plain leaves out all below "
    "the first.",
    kLayeredFigures};

}  // namespace lacquer::study
