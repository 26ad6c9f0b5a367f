#include "tables/transmission.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace lacquer {

namespace {

using Polynomial = std::array<double, ProfileMoments::kPowers>;

Polynomial product(const Polynomial& a, const Polynomial& b) {
    Polynomial result{};
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; i + j < a.size(); ++j) result[i + j] += a[i] * b[j];
    return result;
}

// cos_theta and its derivative by s, both as polynomials of the critical cosine.
struct Warp {
    Polynomial cosine{}, slope{};
};

Warp warp_at(double s, Contrast contrast) {
    if (contrast == Contrast::dense) return {{s * s}, {2.0 * s}};
    const double t = 1.0 - 2.0 * s;
    if (t > 0.0) return {{0.0, 1.0 - t * t}, {0.0, 4.0 * t}};
    return {{t * t, 1.0 - t * t}, {-4.0 * t, 4.0 * t}};
}

double polynomial_at(const ProfileMoments::Polynomials& polynomials, std::size_t profile,
                     double critical) {
    double value = 0.0;
    for (std::size_t power = ProfileMoments::kPowers; power-- > 0;)
        value = value * critical + polynomials[power][profile];
    return value;
}

std::vector<double> profile_values(const TableArray& profile, double s) {
    const double position = s * static_cast<double>(profile.axes[0].size - 1);
    return interpolate(profile, std::array{position});
}

void require_shape(const Table& table, const TableArray& array, std::vector<std::string> axes,
                   std::size_t channels) {
    bool fits = array.axes.size() == axes.size() + 1 && array.channels() == channels;
    for (std::size_t n = 0; fits && n < axes.size(); ++n) fits = array.axes[n].name == axes[n];
    if (!fits)
        throw Error{fmt::format("table '{}', array '{}': expected axes {} and {} channels",
                                table.name, array.name, fmt::join(axes, ", "), channels)};
}

}  // namespace

ProfileMoments integrate_profiles(const TableArray& profile, Contrast contrast) {
    // Exact: between two nodes the integrands are polynomials of degree at most 9 in s, which five
    // Gauss-Legendre points integrate.
    constexpr std::array<double, 5> kPoints{-0.9061798459386640, -0.5384693101056831, 0.0,
                                            0.5384693101056831, 0.9061798459386640};
    constexpr std::array<double, 5> kWeights{0.2369268850561891, 0.4786286704993665,
                                             0.5688888888888889, 0.4786286704993665,
                                             0.2369268850561891};
    const std::size_t segments = profile.axes[0].size - 1;
    const double step = 1.0 / static_cast<double>(segments);
    const std::size_t channels = profile.channels();
    ProfileMoments moments;
    for (auto* polynomials : {&moments.energy, &moments.spread})
        polynomials->fill(std::vector<double>(channels, 0.0));
    for (std::size_t segment = 0; segment < segments; ++segment) {
        for (std::size_t point = 0; point < kPoints.size(); ++point) {
            const double s = (static_cast<double>(segment) + 0.5 * (1.0 + kPoints[point])) * step;
            const Warp warp = warp_at(s, contrast);
            const Polynomial cos_dcos = product(warp.cosine, warp.slope);
            const Polynomial cos3_dcos = product(product(warp.cosine, warp.cosine), cos_dcos);
            const std::vector<double> values = profile_values(profile, s);
            for (std::size_t power = 0; power < ProfileMoments::kPowers; ++power)
                for (std::size_t m = 0; m < channels; ++m) {
                    const double weighted = 0.5 * kWeights[point] * step * values[m];
                    moments.energy[power][m] += weighted * cos_dcos[power];
                    moments.spread[power][m] += weighted * cos3_dcos[power];
                }
        }
    }
    return moments;
}

std::vector<double> energy_moments(const ProfileMoments& moments, double eta) {
    std::vector<double> energies;
    for (std::size_t m = 0; m < moments.energy.front().size(); ++m)
        energies.push_back(polynomial_at(moments.energy, m, critical_cosine(eta)));
    return energies;
}

TransmissionProfile::TransmissionProfile(const TableArray& profile, const ProfileMoments& moments,
                                         double eta, const std::array<double, kProfiles>& weights)
    : profile_{&profile}, eta_{eta}, weights_{weights} {
    for (std::size_t m = 0; m < kProfiles; ++m) {
        energy_ += weights[m] * polynomial_at(moments.energy, m, critical_cosine(eta));
        spread_ += weights[m] * polynomial_at(moments.spread, m, critical_cosine(eta));
    }
}

double TransmissionProfile::at(double cos_theta) const {
    const std::vector<double> values =
        profile_values(*profile_, profile_coordinate(cos_theta, eta_));
    double sum = 0.0;
    for (std::size_t m = 0; m < kProfiles; ++m) sum += weights_[m] * values[m];
    return std::clamp(sum, 0.0, 1.0);
}

double TransmissionProfile::average() const {
    return std::max(0.0, 2.0 * energy_);
}

double TransmissionProfile::variance() const {
    return energy_ > 0.0 ? 0.5 * (1.0 - spread_ / energy_) : 0.0;
}

TransmissionTable::TransmissionTable(const Table& table, Contrast contrast)
    : maps_{table.array("maps")},
      profile_{table.array("profile")},
      absorption_{table.array("absorption")} {
    require_shape(table, maps_, {"alpha", "eta"}, kProducts);
    require_shape(table, profile_, {"s"}, kProfiles);
    require_shape(table, absorption_, {"tau"}, kAbsorptions);
    moments_ = integrate_profiles(profile_, contrast);
}

TransmissionProfile TransmissionTable::profile(double alpha, double eta, double tau) const {
    const std::vector<double> maps = interpolate(
        maps_, std::array{axis_position(maps_.axes[0], alpha), axis_position(maps_.axes[1], eta)});
    const std::vector<double> absorption =
        interpolate(absorption_, std::array{axis_position(absorption_.axes[0], tau)});
    std::array<double, kProfiles> weights{};
    auto product = maps.begin();
    for (std::size_t k = 0; k < kAbsorptions; ++k)
        for (std::size_t m = 0; m < kProfilesOf[k]; ++m) weights[m] += *product++ * absorption[k];
    return {profile_, moments_, eta, weights};
}

}  // namespace lacquer
