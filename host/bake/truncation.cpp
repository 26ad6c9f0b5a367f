#include "bake/truncation.h"

#include "bake/accuracy.h"

namespace lacquer::bake {

namespace {

constexpr std::size_t kStride = 97;  // of the nodes looked at: a thousandth of the time

using Tables = std::array<Table, kTableNames.size()>;

// The table with the coefficients of all but the first functions set to 0.
Table truncated(Table table, std::size_t absorptions, std::size_t profiles) {
    for (TableArray& array : table.arrays) {
        if (array.name != "maps") continue;
        for (std::size_t node = 0; node < array.values.size(); node += kProducts) {
            std::size_t product = node;
            for (std::size_t k = 0; k < kAbsorptions; ++k)
                for (std::size_t m = 0; m < kProfilesOf[k]; ++m, ++product)
                    if (k >= absorptions || m >= profiles) array.values[product] = 0.0;
        }
    }
    return table;
}

}  // namespace

std::vector<Truncation> truncation_errors(const Tables& tables, std::size_t index,
                                          const Quantity& quantity, const DenseValues& dense) {
    const auto record = [&](std::size_t absorptions, std::size_t profiles, Truncation& result) {
        Tables changed = tables;
        changed[index] = truncated(tables[index], absorptions, profiles);
        const ErrorSummary errors = judge_on_grid(quantity, dense, EnergyTables{changed}, kStride);
        result.mean.push_back(errors.mean);
        result.p99.push_back(errors.p99);
    };
    const std::string name = index == 0 ? "T01, eta < 1: " : "T01, eta >= 1: ";
    Truncation of_tau{name + "functions of tau", {}, {}};
    for (std::size_t n = 1; n <= kAbsorptions; ++n) record(n, kProfiles, of_tau);
    Truncation of_cosine{name + "functions of cos_theta", {}, {}};
    for (std::size_t n = 1; n <= kProfiles; ++n) record(kAbsorptions, n, of_cosine);
    return {of_tau, of_cosine};
}

}  // namespace lacquer::bake
