// Blended surfaces in pictures: simulated, as the linear blend of uniform surfaces, and by every
// model that can shade them, with what an eye makes of the differences.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/model.h"
#include "study/figure.h"
#include "study/heightfields/scene.h"
#include "study/run.h"

namespace lacquer::study {

// What errors call the mixture of the uniform surfaces' simulated light.
inline constexpr const char* kLinearBlend = "linear blend";

// FLIP up to this has colours of its own.
inline constexpr double kFlipLimit = 0.3;

// What the errors of pictures are.
extern const char* const kBlendMeasure;

// The models that are measured on blends, where they can shade them.
std::span<const Model> blend_models();

// Adds a table of pictures of `materials` in `scene`, with a row of FLIP's maps below each; the
// errors; and a table of FLIP's means. `title` is unique in the figure.
void add_blends(Figure& figure, const std::string& title, std::span<const Material> materials,
                const Scene& scene, const StudyRun& run);

}  // namespace lacquer::study
