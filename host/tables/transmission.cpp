#include "tables/transmission.h"

#include <algorithm>
#include <span>

namespace lacquer {

namespace {

std::vector<double> at_interface(const TableArray& maps, double alpha, double eta) {
    return interpolate(
        maps, std::array{axis_position(maps.axes[0], alpha), axis_position(maps.axes[1], eta)});
}

// Sums over the functions of tau, whose products with the polynomials are `products`.
Coefficients contract(std::span<const double> products, std::span<const double> absorption,
                      const CoefficientCounts& counts) {
    Coefficients coefficients{};
    auto product = products.begin();
    for (std::size_t k = 0; k < kAbsorptions; ++k)
        for (std::size_t n = 0; n < counts[k]; ++n) coefficients[n] += *product++ * absorption[k];
    return coefficients;
}

std::vector<double> absorption_at(const TableArray& absorption, double tau) {
    return interpolate(absorption, std::array{axis_position(absorption.axes[0], tau)});
}

Coefficients clear_at(const TableArray& clear, double alpha, double eta) {
    const std::vector<double> values = at_interface(clear, alpha, eta);
    Coefficients coefficients{};
    std::copy(values.begin(), values.end(), coefficients.begin());
    return coefficients;
}

}  // namespace

double TransmissionProfile::at(double cos_theta) const {
    return std::clamp(polynomial_.at(cos_theta), 0.0, 1.0);
}

double TransmissionProfile::average() const {
    return std::max(0.0, 2.0 * polynomial_.energy());
}

double TransmissionProfile::variance() const {
    const double energy = polynomial_.energy();
    return energy > 0.0 ? std::clamp(0.5 * (1.0 - polynomial_.spread() / energy), 0.0, 0.5) : 0.0;
}

TableArray clear_coefficients(const Table& table, std::string_view side, Contrast contrast) {
    const TableArray& maps = table.array(side);
    const std::vector<double> absorption = absorption_at(table.array("absorption"), 1.0);
    TableArray clear{"clear_" + std::string{side}, maps.axes, {}};
    clear.axes.back() = {"coefficient", Mapping::index, kCoefficients, 0.0, 0.0, "1"};
    for (std::size_t first = 0; first < maps.values.size(); first += maps.channels()) {
        const Coefficients sums = contract(std::span{maps.values}.subspan(first, maps.channels()),
                                           absorption, coefficient_counts(contrast));
        clear.values.insert(clear.values.end(), sums.begin(), sums.end());
    }
    round_to_encoding(clear);
    return clear;
}

TransmissionTable::TransmissionTable(const Table& table, Contrast contrast) : contrast_{contrast} {
    constexpr std::array<std::string_view, 2> kNode{"alpha", "eta"};
    constexpr std::array<std::string_view, 1> kTau{"tau"};
    const std::size_t channels = coefficient_channels(contrast);
    above_ = table.array("above", kNode, channels);
    absorption_ = table.array("absorption", kTau, kAbsorptions);
    clear_above_ = clear_coefficients(table, "above", contrast);
    if (contrast != Contrast::thin) return;
    below_ = table.array("below", kNode, channels);
    clear_below_ = clear_coefficients(table, "below", contrast);
}

TransmissionProfile TransmissionTable::profile(double alpha, double eta, double tau) const {
    const std::vector<double> absorption = absorption_at(absorption_, tau);
    const CoefficientCounts& counts = coefficient_counts(contrast_);
    DirectionPolynomial polynomial{critical_cosine(eta), {}, {}};
    polynomial.above = contract(at_interface(above_, alpha, eta), absorption, counts);
    if (contrast_ == Contrast::thin)
        polynomial.below = contract(at_interface(below_, alpha, eta), absorption, counts);
    return TransmissionProfile{polynomial};
}

DirectionPolynomial TransmissionTable::clear_profile(double alpha, double eta) const {
    DirectionPolynomial polynomial{critical_cosine(eta), {}, {}};
    polynomial.above = clear_at(clear_above_, alpha, eta);
    if (contrast_ == Contrast::thin) polynomial.below = clear_at(clear_below_, alpha, eta);
    return polynomial;
}

}  // namespace lacquer
