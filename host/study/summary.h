// The errors of a study, figure by figure.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/suite.h"

namespace lacquer::study {

// The models that several figures have errors of, in order.
std::vector<std::string> common_models(const StudyResult& result);

// Over all subjects of a figure: the mean of means, the largest error with its subject and place.
// Nothing where the figure has no errors of that model.
std::optional<ModelError> overall_error(const Figure& figure, const std::string& model);

// For a terminal: one line per figure and model.
std::string summary_text(const StudyResult& result);

}  // namespace lacquer::study
