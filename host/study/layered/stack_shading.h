// The model `stack` as studies ask for it.
#pragma once

#include <memory>

#include "lacquer/material.h"
#include "reference/models.h"
#include "tables/energy_tables.h"

namespace lacquer::study {

// What a viewer sees of a stack takes long to find, and then serves many lights: each thread keeps
// that of its last viewer. `tables` must outlive the result. Throws Error saying what the model
// cannot shade.
std::shared_ptr<const reference::Shading> stack_shading(const Material& material,
                                                        const EnergyTables& tables);

}  // namespace lacquer::study
