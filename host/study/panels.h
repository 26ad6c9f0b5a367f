// The panels of a figure as HTML.
#pragma once

#include <string>

#include "study/figure.h"

namespace lacquer::study {

std::string panel_html(const Panel& panel);

// One row per model, one column per subject; nothing where the figure has no errors.
std::string errors_html(const Figure& figure);

// A table cell of an error, coloured by its size; `detail` shows when pointed at.
std::string error_cell(double mean, const std::string& below, const std::string& detail);

}  // namespace lacquer::study
