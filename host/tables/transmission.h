// T01, the light that enters a rough dielectric interface and crosses the medium below, from its
// compressed table; and what follows from it exactly.
// Based on: de Dinechin and Belcour 2022, Rendering Layered Materials with Diffuse Interfaces,
//           section 4 (the compression), Eq. 3 (the energies)
//
//   T01(cos_theta, alpha, eta, tau) =
//       sum over k, n of maps_kn(alpha, eta) absorption_k(tau) T_n(x(cos_theta, eta))
//
// with the polynomials of tables/polynomial.h. Averages over cosine-weighted directions are
// integrals of this sum, so that they agree with it whatever the compression.
#pragma once

#include <array>
#include <string_view>

#include "tables/polynomial.h"
#include "tables/profile.h"
#include "tables/table.h"

namespace lacquer {

inline constexpr std::size_t kAbsorptions = 5;  // functions of tau

// Polynomials that each function of tau is multiplied with, to each side of the critical angle.
using CoefficientCounts = std::array<std::size_t, kAbsorptions>;
inline constexpr CoefficientCounts kThinCoefficients{8, 8, 6, 6, 4};
inline constexpr CoefficientCounts kDenseCoefficients{8, 8, 8, 8, 8};

constexpr const CoefficientCounts& coefficient_counts(Contrast contrast) {
    return contrast == Contrast::thin ? kThinCoefficients : kDenseCoefficients;
}

// Channels of an array of coefficients: their sum.
constexpr std::size_t coefficient_channels(Contrast contrast) {
    std::size_t sum = 0;
    for (const std::size_t count : coefficient_counts(contrast)) sum += count;
    return sum;
}

// T01 at one interface and medium as a function of direction: what shading keeps per colour
// channel.
class TransmissionProfile {
 public:
    explicit TransmissionProfile(const DirectionPolynomial& polynomial) : polynomial_{polynomial} {}

    // cos_theta in [0, 1].
    double at(double cos_theta) const;

    // 2 * integral of T01(cos) cos dcos: light arriving from everywhere.
    double average() const;

    // Per axis of the projected disk, of light distributed as T01(cos) cos over the hemisphere; 0
    // where no light gets through.
    double variance() const;

    const DirectionPolynomial& polynomial() const { return polynomial_; }

 private:
    DirectionPolynomial polynomial_;
};

// Coefficients of T01 at tau 1 over (alpha, eta): sums of the maps of `side`, "above" or "below",
// over the functions of tau, rounded to half as shaders read them.
TableArray clear_coefficients(const Table& table, std::string_view side, Contrast contrast);

// One of the two tables of T01.
class TransmissionTable {
 public:
    // Throws Error where the table has not the arrays and sizes that it should have.
    TransmissionTable(const Table& table, Contrast contrast);

    TransmissionProfile profile(double alpha, double eta, double tau) const;

    // T01 at tau 1 from clear_coefficients.
    DirectionPolynomial clear_profile(double alpha, double eta) const;

 private:
    Contrast contrast_;
    TableArray below_, above_, absorption_;  // `below_` is empty for dense
    TableArray clear_below_, clear_above_;   // the same
};

}  // namespace lacquer
