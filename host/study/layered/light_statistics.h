// How much light a stack sends back and how wide it spreads, simulated and by models.
#pragma once

#include <cstdint>
#include <string>

#include "lacquer/material.h"
#include "study/model_light.h"
#include "study/run.h"

namespace lacquer::study {

// Of all light that comes back, or of that which met the base. Means over the channels.
struct Spread {
    double energy = 0.0, energy_error = 0.0;
    // Standard deviation per axis of the directions on the projected disk: 0.5 where they are
    // spread as by a Lambertian surface. 0 where there is no light.
    double width = 0.0, width_error = 0.0;
};

struct LightStatistics {
    Spread all, base;
};

LightStatistics simulate_statistics(const Material& material, double cos_theta_o,
                                    std::uint64_t walks, const StudyRun& run,
                                    const std::string& name);

// Energies are the model's own albedo, widths those of its lobes by 1024 of its samples, to about
// a hundredth of them.
LightStatistics model_statistics(const ModelLight& model, double cos_theta_o);

}  // namespace lacquer::study
