// Energies and widths of stacks over one of their parameters, simulated and by models.
#pragma once

#include <functional>
#include <string>

#include "lacquer/material.h"
#include "study/diffuse_interfaces/abscissa.h"
#include "study/figure.h"
#include "study/run.h"

namespace lacquer::study {

// Stacks of one parameter.
struct StackFamily {
    std::string name;
    Abscissa over;
    double cos_theta_o = 1.0;
    std::function<Material(double x)> at;
};

// Three plots: the albedo, the width of all light, and that of light which met the base, where it
// is at least a hundredth; adds the errors of all models, of widths relative.
Plots statistics_plots(Figure& figure, const StackFamily& family, const StudyRun& run);

// What the errors of those are.
extern const char* const kStatisticsMeasure;

}  // namespace lacquer::study
