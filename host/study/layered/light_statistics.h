// How much light a stack sends back and how wide it spreads, simulated and by models.
#pragma once

#include <cstdint>
#include <string>

#include "lacquer/material.h"
#include "study/layered/disk_moments.h"
#include "study/model_light.h"
#include "study/run.h"

namespace lacquer::study {

// Means over the channels, of all light that comes back and of that which met the base.
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
