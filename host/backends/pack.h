// Materials as the rows of four floats that kernels read.
#pragma once

#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "core/model.h"
#include "lacquer/material.h"

namespace lacquer {

// Rows per material for `model`.
std::size_t surface_rows(Model model);

// Packs each material into surface_rows(model) rows. Throws Error naming the material and the JSON
// pointer of a feature that the model cannot shade (core/model_scope.h).
std::vector<glm::vec4> pack_surfaces(Model model, std::span<const Material> materials);

}  // namespace lacquer
