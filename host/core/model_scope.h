// Which materials a model can shade.
#pragma once

#include <optional>
#include <string>

#include "core/model.h"
#include "lacquer/material.h"

namespace lacquer {

// Why `model` cannot shade the material: the JSON pointer of the first feature that it has no
// formula for, and what it says of it ("/layers/1: the model 'clearcoat' shades at most one
// layer"). Nothing where it can.
std::optional<std::string> why_not_shadeable(const Material& material, Model model);

// Throws Error naming the material and saying why `model` cannot shade it, where it cannot.
void require_shadeable(const Material& material, Model model);

}  // namespace lacquer
