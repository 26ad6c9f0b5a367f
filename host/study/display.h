// The pictures of a study as a display shows them.
#pragma once

#include <string>

#include "study/figure.h"

namespace lacquer::study {

// A PNG: radiance through the tone curve, differences in colours of their kind.
std::string png_of(const Picture& picture);

// The colours of differences up to `limit`, with what they mean: HTML.
std::string difference_legend(double limit, const std::string& below = "too dark",
                              const std::string& above = "too bright");

// The colours of FLIP up to `limit`: HTML.
std::string flip_legend(double limit);

}  // namespace lacquer::study
