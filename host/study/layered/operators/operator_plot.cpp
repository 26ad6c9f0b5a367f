#include "study/layered/operators/operator_plot.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <cmath>

#include "study/layered/error_sizes.h"

namespace lacquer::study {

namespace {

constexpr int kLinePoints = 40;

std::vector<std::optional<Measured>> simulate(const OperatorCase& one,
                                              const std::vector<double>& positions) {
    std::vector<std::optional<Measured>> dots(positions.size());
    tbb::parallel_for(std::size_t{0}, positions.size(),
                      [&](std::size_t n) { dots[n] = one.simulate(positions[n]); });
    return dots;
}

Curve dots_of(const std::vector<double>& positions,
              const std::vector<std::optional<Measured>>& dots) {
    Curve curve{"simulation"};
    curve.dots = true;
    for (std::size_t n = 0; n < dots.size(); ++n) {
        if (!dots[n]) continue;
        curve.x.push_back(positions[n]);
        curve.y.push_back(dots[n]->value);
        curve.errors.push_back(dots[n]->standard_error);
    }
    return curve;
}

// A formula as a line, where it is finite.
Curve line_of(const Formula& formula, const Abscissa& over) {
    Curve curve{formula.name};
    std::vector<double> values(kLinePoints + 1);
    tbb::parallel_for(0, kLinePoints + 1, [&](int n) {
        values[static_cast<std::size_t>(n)] = formula.value(over.at(double(n) / kLinePoints));
    });
    for (int n = 0; n <= kLinePoints; ++n) {
        const double value = values[static_cast<std::size_t>(n)];
        if (!std::isfinite(value)) continue;
        curve.x.push_back(over.at(double(n) / kLinePoints));
        curve.y.push_back(value);
    }
    return curve;
}

void tally_dots(const OperatorCheck& check, const OperatorCase& one, const Formula& formula,
                const std::vector<double>& positions,
                const std::vector<std::optional<Measured>>& dots, ErrorSizes& errors) {
    for (std::size_t n = 0; n < dots.size(); ++n) {
        if (!dots[n]) continue;
        const double scale = check.is_relative ? dots[n]->value : 1.0;
        const double error = (formula.value(positions[n]) - dots[n]->value) / scale;
        errors.add(error, dots[n]->standard_error / scale, [&] {
            return fmt::format("{}, {} {:.3g}", one.title, check.over.name, positions[n]);
        });
    }
}

Plot plot_of(const OperatorCheck& check, const OperatorCase& one) {
    Plot plot = empty_plot(one.title, check.over, check.quantity, check.top);
    plot.y_from = check.bottom;
    return plot;
}

}  // namespace

NumberTable operator_table() {
    return {"", error_columns("quantity", "formula"), {}};
}

void add_check(Figure& figure, NumberTable& table, const OperatorCheck& check,
               const StudyRun& run) {
    const std::vector<double> positions = dot_positions(check.over);
    std::vector<ErrorSizes> errors;  // over all dots of all cases
    for (const Formula& formula : check.cases.front().formulas)
        errors.emplace_back(check.subject, formula.name);
    Plots plots{check.subject, {}};
    for (const OperatorCase& one : check.cases) {
        run.part(check.subject + ", " + one.title);
        const auto dots = simulate(one, positions);
        Plot plot = plot_of(check, one);
        plot.curves.push_back(dots_of(positions, dots));
        for (std::size_t n = 0; n < one.formulas.size(); ++n) {
            plot.curves.push_back(line_of(one.formulas[n], check.over));
            tally_dots(check, one, one.formulas[n], positions, dots, errors[n]);
        }
        plots.plots.push_back(std::move(plot));
    }
    figure.panels.emplace_back(std::move(plots));
    for (const ErrorSizes& of : errors) {
        figure.errors.push_back(of.result());
        table.rows.push_back(of.row());
    }
}

}  // namespace lacquer::study
