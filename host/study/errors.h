// Questions about the errors of figures.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/figure.h"

namespace lacquer::study {

// What a figure's errors name, each once, in order.
std::vector<std::string> error_subjects(const Figure& figure);
std::vector<std::string> error_models(const Figure& figure);

// nullptr where the model was not measured on the subject.
const ModelError* find_error(const Figure& figure, const std::string& subject,
                             const std::string& model);

// The most that the simulation's noise makes of a mean on that subject.
double noise_of(const Figure& figure, const std::string& subject);

// Over all subjects of a figure: the mean of means, the largest error with its subject and place.
// Nothing where the figure has no errors of that model.
std::optional<ModelError> overall_error(const Figure& figure, const std::string& model);

}  // namespace lacquer::study
