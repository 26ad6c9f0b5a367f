#include "bake/accuracy.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "bake/dielectric.h"
#include "bake/mirror.h"

namespace lacquer::bake {

namespace {

const Axis kCosines{"cos_theta", Mapping::linear, 2, 0.0, 1.0, "1"};
const Axis kAlphas{"alpha", Mapping::linear, 2, 0.0, 1.0, "1"};
const Axis kEtas{"eta", Mapping::log_bent, 2, 1.0 / 3.0, 3.0, "1"};
const Axis kTaus{"tau", Mapping::linear, 2, 0.0, 1.0, "1"};

double draw(const Axis& axis, double number) {
    if (axis.mapping == Mapping::log_bent) return axis.from * std::pow(axis.to / axis.from, number);
    return axis.from + (axis.to - axis.from) * number;
}

Check check_of_t_down() {
    return {"T01",
            {kCosines, kAlphas, kEtas, kTaus},
            [](const EnergyTables& tables, const Parameters& p) {
                return tables.t_down(p[0], p[1], p[2], p[3]);
            },
            [](const Parameters& p, const SobolPoints& points, std::uint64_t seed) {
                return light_entering(p[0], p[1], p[2], points, seed).transmitted(p[3]);
            }};
}

Check check_of_t_up() {
    return {"T10_bar",
            {kAlphas, kEtas, kTaus},
            [](const EnergyTables& tables, const Parameters& p) {
                return tables.t_up(p[0], p[1], p[2]);
            },
            [](const Parameters& p, const SobolPoints& points, std::uint64_t seed) {
                return light_leaving(p[0], p[1], points, seed).left.transmitted(p[2]);
            }};
}

Check check_of_r_up() {
    return {"R10_bar",
            {kAlphas, kEtas, kTaus},
            [](const EnergyTables& tables, const Parameters& p) {
                return tables.r_up(p[0], p[1], p[2]);
            },
            [](const Parameters& p, const SobolPoints& points, std::uint64_t seed) {
                return light_leaving(p[0], p[1], points, seed).reflected.transmitted(p[2], 2.0);
            }};
}

Check check_of_dielectric() {
    return {"FGD of dielectrics",
            {kCosines, kAlphas, kEtas},
            [](const EnergyTables& tables, const Parameters& p) {
                return tables.fgd_dielectric(p[0], p[1], p[2]);
            },
            [](const Parameters& p, const SobolPoints& points, std::uint64_t seed) {
                return 1.0 - light_entering(p[0], p[1], p[2], points, seed).transmitted(1.0);
            }};
}

Check check_of_conductor() {
    return {"FGD of conductors",
            {kCosines,
             kAlphas,
             {"eta", Mapping::linear, 2, 0.0, 5.0, "1"},
             {"kappa", Mapping::linear, 2, 0.0, 10.0, "1"}},
            [](const EnergyTables& tables, const Parameters& p) {
                return tables.fgd_conductor(p[0], p[1], p[2], p[3]);
            },
            [](const Parameters& p, const SobolPoints& points, std::uint64_t seed) {
                const FresnelCurves curve{1, [&](std::size_t, double cosine) {
                                              return conductor_reflectance(cosine, p[2], p[3]);
                                          }};
                return reflected_by_facets(p[0], p[1], curve, points, seed).front();
            }};
}

Check check_of_tir() {
    return {"TIR",
            {kCosines, kAlphas, kEtas},
            [](const EnergyTables& tables, const Parameters& p) {
                return tables.tir(p[0], p[1], p[2]);
            },
            [](const Parameters& p, const SobolPoints& points, std::uint64_t seed) {
                return lobe_transmittance(p[0], p[1], p[2], points, seed);
            }};
}

Check check_of_multiple() {
    return {"FGD after more than one facet",
            {kCosines, kAlphas, kEtas},
            [](const EnergyTables& tables, const Parameters& p) {
                return tables.fgd_multiple(p[0], p[1], p[2]);
            },
            [](const Parameters& p, const SobolPoints& points, std::uint64_t seed) {
                return light_reflected_again(p[0], p[1], p[2], points, seed);
            }};
}

Check check_of_mirror() {
    return {"single-scattering mirrors",
            {kCosines, kAlphas},
            [](const EnergyTables& tables, const Parameters& p) {
                return tables.mirror_single(p[0], p[1]);
            },
            [](const Parameters& p, const SobolPoints& points, std::uint64_t seed) {
                return reflected_once(p[0], p[1], points, seed);
            }};
}

Check check_of_lobes() {
    return {"mean cosine of lobe nodes",
            {kCosines, kAlphas},
            [](const EnergyTables& tables, const Parameters& p) {
                const auto nodes = tables.lobe(p[0], p[1]).cosines;
                return std::accumulate(nodes.begin(), nodes.end(), 0.0) / kLobeNodes;
            },
            [](const Parameters& p, const SobolPoints& points, std::uint64_t seed) {
                return mean_lobe_cosine(p[0], p[1], points, seed);
            }};
}

ErrorSummary summarise(std::vector<double> errors, const std::vector<Parameters>& where) {
    ErrorSummary summary;
    const auto worst = std::max_element(errors.begin(), errors.end()) - errors.begin();
    summary.max = errors[static_cast<std::size_t>(worst)];
    summary.worst = where[static_cast<std::size_t>(worst)];
    for (const double error : errors) summary.mean += error / static_cast<double>(errors.size());
    const auto rank = static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(errors.size() - 1));
    std::nth_element(errors.begin(), errors.begin() + rank, errors.end());
    summary.p99 = errors[static_cast<std::size_t>(rank)];
    return summary;
}

}  // namespace

std::vector<Check> all_checks() {
    return {check_of_t_down(),     check_of_t_up(),     check_of_r_up(),
            check_of_dielectric(), check_of_multiple(), check_of_conductor(),
            check_of_tir(),        check_of_mirror(),   check_of_lobes()};
}

ErrorSummary judge_off_grid(const Check& check, const EnergyTables& tables, std::size_t count,
                            const BakeSettings& settings) {
    std::mt19937_64 random{settings.seed};
    std::vector<Parameters> where(count);
    for (Parameters& parameters : where)
        for (const Axis& axis : check.ranges)
            parameters.push_back(draw(axis, static_cast<double>(random() >> 11) * 0x1p-53));
    const SobolPoints points{settings.samples};
    std::vector<double> errors(count);
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t n) {
        const double truth = check.simulate(where[n], points, mix_bits(settings.seed ^ (n + 1)));
        errors[n] = std::abs(check.look_up(tables, where[n]) - truth);
    });
    return summarise(std::move(errors), where);
}

ErrorSummary judge_on_grid(std::span<const Quantity> quantities, std::span<const DenseValues> dense,
                           const EnergyTables& tables, std::size_t stride) {
    std::vector<double> errors;
    std::vector<Parameters> where;
    for (std::size_t q = 0; q < quantities.size(); ++q) {
        const std::size_t first = errors.size();
        const std::size_t count = (dense[q].size() + stride - 1) / stride;
        errors.resize(first + count);
        where.resize(first + count);
        tbb::parallel_for(std::size_t{0}, count, [&](std::size_t n) {
            where[first + n] = grid_parameters(quantities[q].axes, n * stride);
            errors[first + n] =
                std::abs(quantities[q].look_up(tables, where[first + n]) - dense[q][n * stride]);
        });
    }
    return summarise(std::move(errors), where);
}

}  // namespace lacquer::bake
