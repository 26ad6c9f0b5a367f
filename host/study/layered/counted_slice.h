// The light that one viewer gets from each direction, for any stack: walks counted per pixel, and
// models averaged over pixels likewise.
#pragma once

#include "lacquer/material.h"
#include "study/model_light.h"
#include "study/run.h"
#include "study/view.h"

namespace lacquer::study {

// From run.samples / 2 walks; `view` a slice. Pixels that mirror each other in the plane of the
// viewer share their light.
Radiance simulate_counted_slice(const View& view, const Material& material, const StudyRun& run);

// Averaged over each pixel, since the lobes of smooth interfaces are as narrow as one.
Radiance shade_pixels(const View& view, const ModelLight& model);

}  // namespace lacquer::study
