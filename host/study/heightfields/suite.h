// The figures of d'Eon, Bitterli, Weidlich and Zeltner 2023, Microfacet Theory for Non-Uniform
// Heightfields: surfaces whose facets change with height.
#pragma once

#include <array>

#include "study/suite.h"

namespace lacquer::study {

Figure layouts_figure(const StudyRun& run);
Figure lit_diffuse_figure(const StudyRun& run);
Figure damaged_gold_figure(const StudyRun& run);
Figure diffuse_and_coated_figure(const StudyRun& run);
Figure diffuse_colors_figure(const StudyRun& run);

inline constexpr std::array<FigureEntry, 5> kHeightfieldsFigures{{
    {"figure-7", layouts_figure},
    {"figure-9", lit_diffuse_figure},
    {"figure-10", damaged_gold_figure},
    {"figure-11", diffuse_and_coated_figure},
    {"figure-17", diffuse_colors_figure},
}};

inline constexpr Suite kHeightfields{
    "heightfields", "Surfaces that change with height",
    "The figures of d'Eon, Bitterli, Weidlich and Zeltner 2023, Microfacet Theory for Non-Uniform "
    "Heightfields, simulated again",
    "The linear blend mixes the simulated light of the uniform surfaces by their weights, as if "
    "they lay side by side and not one above the other: it is what a renderer without this theory "
    "does. microsurface-single is the closed form of light that meets one facet; "
    "microsurface-compensated adds what meets several as a diffuse lobe.",
    kHeightfieldsFigures};

}  // namespace lacquer::study
