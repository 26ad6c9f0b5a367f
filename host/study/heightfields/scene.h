// The ways in which the suite looks at a material.
#pragma once

#include <functional>
#include <string_view>

#include "study/model_light.h"
#include "study/run.h"
#include "study/view.h"

namespace lacquer::study {

struct Scene {
    View view;
    // The radiance that walks of all orders find; independent for another `name`.
    std::function<Radiance(const Material& material, std::string_view name)> simulate;
    std::function<Radiance(const ModelLight& model)> shade;
};

// A ball in a room, by so many walks as run.samples and more.
Scene studio_ball(const StudyRun& run);

// A ball under one light at `angle_deg` from the viewer, to the left; its light at each pixel is
// estimated by next events: of materials that are one rough surface.
Scene lit_ball(double angle_deg, const StudyRun& run);

}  // namespace lacquer::study
