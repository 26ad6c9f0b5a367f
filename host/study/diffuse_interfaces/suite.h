// The figures of de Dinechin and Belcour 2022, Rendering Layered Materials with Diffuse Interfaces:
// a rough coat over a Lambertian base.
#pragma once

#include <array>

#include "study/suite.h"

namespace lacquer::study {

Figure statistics_figure(const StudyRun& run);
Figure spheres_figure(const StudyRun& run);
Figure compression_figure(const StudyRun& run);
Figure validation_figure(const StudyRun& run);
Figure multiple_scattering_figure(const StudyRun& run);
Figure absorption_figure(const StudyRun& run);
Figure lobes_figure(const StudyRun& run);
Figure furnace_figure(const StudyRun& run);
Figure random_materials_figure(const StudyRun& run);

inline constexpr std::array<FigureEntry, 9> kDiffuseInterfacesFigures{{
    {"figure-3", statistics_figure},
    {"figure-4", spheres_figure},
    {"figure-5", compression_figure},
    {"figure-7", validation_figure},
    {"figure-8", multiple_scattering_figure},
    {"figure-9", absorption_figure},
    {"figure-11", lobes_figure},
    {"white-furnace", furnace_figure},
    {"random-materials", random_materials_figure},
}};

inline constexpr Suite kDiffuseInterfaces{
    "diffuse-interfaces", "A rough coat over a Lambertian base",
    "The figures of de Dinechin and Belcour 2022, Rendering Layered Materials with Diffuse "
    "Interfaces, simulated again",
    "coated-exact and coated-ggx are this project's models of the paper; openpbr-coat, clearcoat, "
    "weidlich-wilkie and plain are what they are measured against.",
    kDiffuseInterfacesFigures};

}  // namespace lacquer::study
