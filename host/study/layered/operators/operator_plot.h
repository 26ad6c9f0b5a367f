// What one operator makes of light, over a parameter: simulated, and by formulas.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "study/diffuse_interfaces/abscissa.h"
#include "study/figure.h"
#include "study/run.h"

namespace lacquer::study {

struct Measured {
    double value = 0.0, standard_error = 0.0;
};

struct Formula {
    std::string name;  // of the model: the same in all cases of a check
    std::function<double(double x)> value;
};

// One plot. Where the simulation knows nothing it has no dot.
struct OperatorCase {
    std::string title;
    std::function<std::optional<Measured>(double x)> simulate;
    std::vector<Formula> formulas;
};

struct OperatorCheck {
    std::string subject;   // of its errors
    std::string quantity;  // on the ordinates
    Abscissa over;
    double bottom = 0.0, top = 1.0;
    bool is_relative = false;  // errors are shares of what is simulated
    std::vector<OperatorCase> cases;
};

// Mean, 95th percentile and largest error of every formula, one row each.
NumberTable operator_table();

// Appends its plots and errors to the figure and its rows to the table.
void add_check(Figure& figure, NumberTable& table, const OperatorCheck& check, const StudyRun& run);

}  // namespace lacquer::study
