// The models that the suite measures, on one material.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/model_light.h"

namespace lacquer::study {

struct Compared {
    std::string name;
    std::optional<ModelLight> light{};
    std::string why_not{};  // where the model cannot shade the material
};

// Whether the base's part of the light is asked for, which for stack takes a second preparation.
enum class Need { all_light, base };

// stack and the baselines, the same for every material.
std::vector<Compared> compared_on(const Material& material, Need need = Need::all_light);

// Those that can shade it.
std::vector<ModelLight> lights_of(const std::vector<Compared>& compared);

}  // namespace lacquer::study
