#include "bake/truncation.h"

#include "bake/accuracy.h"

namespace lacquer::bake {

namespace {

constexpr std::size_t kStride = 97;  // of the nodes looked at, which are very many

using Tables = std::array<Table, kTableNames.size()>;

}  // namespace

Table truncated(Table table, Contrast contrast, std::size_t absorptions, std::size_t polynomials) {
    const CoefficientCounts& counts = coefficient_counts(contrast);
    for (TableArray& array : table.arrays) {
        if (array.name == "absorption") continue;
        std::size_t index = 0;
        while (index < array.values.size())
            for (std::size_t k = 0; k < kAbsorptions; ++k)
                for (std::size_t n = 0; n < counts[k]; ++n, ++index)
                    if (k >= absorptions || n >= polynomials) array.values[index] = 0.0;
    }
    return table;
}

std::vector<Truncation> truncation_errors(const Tables& tables, std::size_t index,
                                          const Quantity& quantity, const DenseValues& dense) {
    const Contrast contrast = index == 0 ? Contrast::thin : Contrast::dense;
    const auto record = [&](std::size_t absorptions, std::size_t polynomials, Truncation& result) {
        Tables changed = tables;
        changed[index] = truncated(tables[index], contrast, absorptions, polynomials);
        const ErrorSummary errors =
            judge_on_grid({&quantity, 1}, {&dense, 1}, EnergyTables{changed}, kStride);
        result.mean.push_back(errors.mean);
        result.p99.push_back(errors.p99);
    };
    const std::string name = index == 0 ? "T01, eta < 1: " : "T01, eta >= 1: ";
    Truncation of_tau{name + "functions of tau", {}, {}};
    for (std::size_t n = 1; n <= kAbsorptions; ++n) record(n, kCoefficients, of_tau);
    Truncation of_cosine{name + "polynomials of cos_theta", {}, {}};
    for (std::size_t n = 1; n <= kCoefficients; ++n) record(kAbsorptions, n, of_cosine);
    return {of_tau, of_cosine};
}

}  // namespace lacquer::bake
