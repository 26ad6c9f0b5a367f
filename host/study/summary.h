// The errors of a study, figure by figure.
#pragma once

#include <string>
#include <vector>

#include "study/suite.h"

namespace lacquer::study {

// The models that several figures have errors of, or the only one, in order.
std::vector<std::string> common_models(const StudyResult& result);

// For a terminal: one line per figure and model.
std::string summary_text(const StudyResult& result);

}  // namespace lacquer::study
