// What each basis function of T01's compression is worth: errors when fewer are kept.
// Based on: de Dinechin and Belcour 2022, figure 5
#pragma once

#include <array>
#include <string>
#include <vector>

#include "bake/quantity.h"
#include "tables/energy_tables.h"

namespace lacquer::bake {

// A table of T01 with the coefficients of all but the first functions set to 0: so many functions
// of tau, each over at most so many polynomials of cos_theta.
Table truncated(Table table, Contrast contrast, std::size_t absorptions, std::size_t polynomials);

// Absolute errors on the grid of the dense bake, by the number of functions kept, from 1.
struct Truncation {
    std::string functions;  // "T01, eta < 1: functions of tau"
    std::vector<double> mean, p99;
};

// Of one table of T01, `index` in kTableNames: fewer functions of tau, then fewer of cos_theta.
std::vector<Truncation> truncation_errors(const std::array<Table, kTableNames.size()>& tables,
                                          std::size_t index, const Quantity& quantity,
                                          const DenseValues& dense);

}  // namespace lacquer::bake
