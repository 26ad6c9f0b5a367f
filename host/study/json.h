// A study as JSON, for other programs. The shape is stable; keys may be added.
#pragma once

#include <string>

#include "study/suite.h"

namespace lacquer::study {

// {"version", "suite", "samples", "seed", "figures": [{"id", "title", "caption", "measure",
// "errors": [{"subject", "model", "mean", "max", "noise", "where"}], "panels": [...]}]}. A panel is
// {"kind": "pictures", "title", "columns", "rows": [{"label", "pictures": [{"file", "limit"} or
// null]}]}, {"kind": "plots", "title", "plots": [{"title", "x", "y", "curves": [{"label", "x", "y",
// "errors"}]}]}, {"kind": "maps", "title", "maps": [{"title", "x", "y", "x_range", "y_range",
// "file", "limit", "values"}]} or {"kind": "table", "title", "columns", "rows"}. "file" is the name
// below the report's folder, without extension; a picture that a model cannot make is {"file":
// null, "note": the reason}. What is not finite is null.
std::string study_json(const StudyResult& result);

// "pictures/FIGURE/NAME".
std::string picture_file(const Figure& figure, const Picture& picture);

}  // namespace lacquer::study
