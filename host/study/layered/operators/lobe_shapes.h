// Figures 6 and 7 of 2018: refracted lobes as curves over the plane of incidence.
#pragma once

#include "study/figure.h"
#include "study/run.h"

namespace lacquer::study {

// Appends plots, errors and rows of the table: how far the reflections that stand for refraction
// are from it in shape.
void add_lobe_shapes(Figure& figure, NumberTable& table, const StudyRun& run);

}  // namespace lacquer::study
