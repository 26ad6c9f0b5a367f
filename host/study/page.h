// A study as one HTML file that needs nothing else.
#pragma once

#include <string>

#include "study/suite.h"

namespace lacquer::study {

std::string page_html(const StudyResult& result);

}  // namespace lacquer::study
