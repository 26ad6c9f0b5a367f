// Directional albedos over the viewer's angle, simulated and by models.
#pragma once

#include <span>
#include <string>

#include "lacquer/material.h"
#include "study/error_tally.h"
#include "study/figure.h"
#include "study/model_light.h"
#include "study/run.h"

namespace lacquer::study {

enum class Light { base, total };  // what the base sends back, or all

struct AlbedoPlot {
    std::string title;
    Light light = Light::total;
    int channel = 0;
    double top = 1.0;  // of the ordinate
};

// Dots of the simulation, with the name of the material for their seeds.
Curve simulated_albedo(const AlbedoPlot& plot, const Material& material, const StudyRun& run);

Curve model_albedo(const AlbedoPlot& plot, const ModelLight& model);

// Both, for all models; `tallies`, one per model or none, take the differences at the dots.
Plot albedo_plot(const AlbedoPlot& plot, const Material& material,
                 std::span<const ModelLight> models, std::span<ErrorTally> tallies,
                 const StudyRun& run);

}  // namespace lacquer::study
