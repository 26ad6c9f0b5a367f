#include "bake/report.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/progress.h"

namespace lacquer::bake {

namespace {

std::string errors_text(const ErrorSummary& errors) {
    return fmt::format("{:.5f} | {:.4f} | {:.4f}", errors.mean, errors.p99, errors.max);
}

std::string place_text(const Parameters& parameters) {
    return fmt::format("{:.3g}", fmt::join(parameters, ", "));
}

}  // namespace

std::string accuracy_text(const BakeRecord& record) {
    std::size_t bytes = 0;
    double seconds = 0.0;
    for (const TableRecord& table : record.tables) {
        bytes += table.bytes;
        seconds += table.seconds;
    }
    std::string text = fmt::format(
        "`{}`: {} walks per node, seed {}, {} of simulation. All tables: {:.1f} KiB.\n\n",
        record.command, record.settings.samples, record.settings.seed, duration_text(seconds),
        static_cast<double>(bytes) / 1024.0);
    text +=
        "Absolute errors of look-ups against the dense bake, on its grid:\n\n"
        "| table | bytes | mean | p99 | max |\n| --- | --- | --- | --- | --- |\n";
    for (const TableRecord& table : record.tables)
        text +=
            fmt::format("| {} | {} | {} |\n", table.name, table.bytes, errors_text(table.on_grid));
    text += fmt::format(
        "\nAbsolute errors of look-ups against fresh simulation at {} random points of the whole "
        "range ({} walks each, whose noise is part of the errors):\n\n"
        "| quantity | mean | p99 | max | worst at |\n| --- | --- | --- | --- | --- |\n",
        record.points, record.point_samples);
    for (const CheckRecord& check : record.checks)
        text += fmt::format("| {} | {} | {} |\n", check.name, errors_text(check.off_grid),
                            place_text(check.off_grid.worst));
    return text;
}

std::string with_accuracy(const std::string& readme, const std::string& text) {
    const std::size_t begin = readme.find(kAccuracyBegin);
    const std::size_t end = readme.find(kAccuracyEnd);
    if (begin == std::string::npos || end == std::string::npos || end < begin)
        throw Error{fmt::format("README.md: '{}' and '{}' are not there to write between",
                                kAccuracyBegin, kAccuracyEnd)};
    return readme.substr(0, begin + kAccuracyBegin.size()) + "\n" + text + readme.substr(end);
}

}  // namespace lacquer::bake
