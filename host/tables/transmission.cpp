#include "tables/transmission.h"

#include <algorithm>

namespace lacquer {

namespace {

Coefficients contract(const TableArray& maps, double alpha, double eta,
                      const std::vector<double>& absorption, const CoefficientCounts& counts) {
    const std::vector<double> products = interpolate(
        maps, std::array{axis_position(maps.axes[0], alpha), axis_position(maps.axes[1], eta)});
    Coefficients coefficients{};
    auto product = products.begin();
    for (std::size_t k = 0; k < kAbsorptions; ++k)
        for (std::size_t n = 0; n < counts[k]; ++n) coefficients[n] += *product++ * absorption[k];
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

TransmissionTable::TransmissionTable(const Table& table, Contrast contrast) : contrast_{contrast} {
    constexpr std::array<std::string_view, 2> kNode{"alpha", "eta"};
    constexpr std::array<std::string_view, 1> kTau{"tau"};
    const std::size_t channels = coefficient_channels(contrast);
    above_ = table.array("above", kNode, channels);
    absorption_ = table.array("absorption", kTau, kAbsorptions);
    if (contrast == Contrast::thin) below_ = table.array("below", kNode, channels);
}

TransmissionProfile TransmissionTable::profile(double alpha, double eta, double tau) const {
    const std::vector<double> absorption =
        interpolate(absorption_, std::array{axis_position(absorption_.axes[0], tau)});
    const CoefficientCounts& counts = coefficient_counts(contrast_);
    DirectionPolynomial polynomial{critical_cosine(eta), {}, {}};
    polynomial.above = contract(above_, alpha, eta, absorption, counts);
    if (contrast_ == Contrast::thin)
        polynomial.below = contract(below_, alpha, eta, absorption, counts);
    return TransmissionProfile{polynomial};
}

}  // namespace lacquer
