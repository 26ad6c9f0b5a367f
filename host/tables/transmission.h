// T01, the light that enters a rough dielectric interface and crosses the medium below, from its
// compressed table; and what follows from it exactly.
// Based on: de Dinechin and Belcour 2022, Rendering Layered Materials with Diffuse Interfaces,
//           section 4 (the compression), Eq. 3 (the energies)
//
//   T01(cos_theta, alpha, eta, tau) =
//       sum over k, m < kProfilesOf[k] of maps_km(alpha, eta) absorption_k(tau) profile_m(s)
//
// with s of tables/profile.h. Averages over cosine-weighted directions are integrals of this sum,
// so that they agree with it whatever the compression.
#pragma once

#include <array>
#include <vector>

#include "tables/profile.h"
#include "tables/table.h"

namespace lacquer {

inline constexpr std::size_t kAbsorptions = 5;  // functions of tau
inline constexpr std::size_t kProfiles = 12;    // functions of s

// The functions of s that each function of tau is multiplied with: the other products carry next to
// nothing.
inline constexpr std::array<std::size_t, kAbsorptions> kProfilesOf{12, 12, 10, 8, 6};
inline constexpr std::size_t kProducts = 48;  // their sum: channels of "maps"

// Integrals of each profile against cos dcos and cos^3 dcos over [0, 1], as polynomials of the
// critical cosine (of degree 0 for dense): coefficient of power p of profile m at [p][m].
struct ProfileMoments {
    static constexpr std::size_t kPowers = 5;
    using Polynomials = std::array<std::vector<double>, kPowers>;
    Polynomials energy, spread;
};

// Of the channels of an array over s.
ProfileMoments integrate_profiles(const TableArray& profile, Contrast contrast);

// The integral of each channel against cos dcos for one interface.
std::vector<double> energy_moments(const ProfileMoments& moments, double eta);

// T01 at one interface and medium as a function of direction: what shading keeps per colour
// channel.
class TransmissionProfile {
 public:
    TransmissionProfile(const TableArray& profile, const ProfileMoments& moments, double eta,
                        const std::array<double, kProfiles>& weights);

    // cos_theta in [0, 1].
    double at(double cos_theta) const;

    // 2 * integral of at(cos) cos dcos: light arriving from everywhere.
    double average() const;

    // Per axis of the projected disk, of light distributed as at(cos) cos over the hemisphere; 0
    // where no light gets through.
    double variance() const;

 private:
    const TableArray* profile_;
    double eta_;
    std::array<double, kProfiles> weights_;
    double energy_ = 0.0, spread_ = 0.0;
};

// One of the two tables of T01.
class TransmissionTable {
 public:
    // Throws Error where the table has not the arrays and sizes that it should have.
    TransmissionTable(const Table& table, Contrast contrast);

    TransmissionProfile profile(double alpha, double eta, double tau) const;

 private:
    TableArray maps_, profile_, absorption_;
    ProfileMoments moments_;
};

}  // namespace lacquer
