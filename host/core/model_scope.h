// Which materials a model can shade.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/model.h"
#include "lacquer/material.h"

namespace lacquer {

// Why `model` cannot shade the material: the JSON pointer of the first feature that it has no
// formula for, and what it says of it ("/layers/1: the model 'clearcoat' shades at most one
// layer"). Nothing where it can.
std::optional<std::string> why_not_shadeable(const Material& material, Model model);

// The models that can shade the material, in the order of all_models: there are materials that only
// the simulator knows.
std::vector<Model> models_for(const Material& material);

// Throws Error naming the material and saying why `model` cannot shade it, where it cannot.
void require_shadeable(const Material& material, Model model);

}  // namespace lacquer
