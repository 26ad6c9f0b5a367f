// One material in pictures: simulated, by every model, and how far each model is off.
#pragma once

#include <span>
#include <string>

#include "core/model.h"
#include "study/figure.h"
#include "study/model_light.h"
#include "study/run.h"
#include "study/view.h"

namespace lacquer::study {

// Differences of radiance up to this have colours: one scale for all pictures.
inline constexpr double kDifferenceLimit = 0.2;

std::vector<ModelLight> models_of(const Material& material, std::span<const Model> models);

// The models that the studies of coats compare, the best first.
std::span<const Model> compared_models();

// What the errors of a view of a material are listed under.
std::string picture_subject(const Material& material, const View& view);

// The name of a picture's files: "eta_0.8_alpha_0.1_sphere_plain".
std::string picture_name(const Material& material, const View& view, const std::string& what);

// Adds a table of pictures to the figure: one column for the simulation `truth` (one of each view)
// and one for each model, two rows for each view, pictures and differences; and the errors.
void add_material(Figure& figure, const Material& material, std::span<const View> views,
                  std::span<const Radiance> truth, std::span<const ModelLight> compared);

}  // namespace lacquer::study
