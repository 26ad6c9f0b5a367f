#include "tables/energy_tables.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "tables/table_file.h"

namespace lacquer {

namespace {

constexpr double kSlack = 1e-6;  // of quotients and cosines of numbers rounded to float

void require(const char* name, double value, double low, double high) {
    if (!(value >= low - kSlack && value <= high + kSlack))
        throw Error{fmt::format("{}: {} is outside [{:.6g}, {:.6g}]", name, value, low, high)};
}

void require_interface(double alpha, double eta) {
    require("alpha", alpha, 0.0, 1.0);
    require("eta", eta, kMinTableEta, kMaxTableEta);
}

std::string prefixed(Contrast contrast, const char* array) {
    return (contrast == Contrast::thin ? "thin_" : "dense_") + std::string{array};
}

std::vector<double> over_two(const TableArray& array, double first, double second) {
    return interpolate(array, std::array{axis_position(array.axes[0], first),
                                         axis_position(array.axes[1], second)});
}

std::vector<double> over_one(const TableArray& array, double value) {
    return interpolate(array, std::array{axis_position(array.axes[0], value)});
}

double dot(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0.0;
    for (std::size_t n = 0; n < std::min(a.size(), b.size()); ++n) sum += a[n] * b[n];
    return sum;
}

Coefficients coefficients_of(const TableArray& array, double alpha, double eta) {
    Coefficients coefficients{};
    const std::vector<double> channels = over_two(array, alpha, eta);
    std::copy_n(channels.begin(), std::min(channels.size(), kCoefficients), coefficients.begin());
    return coefficients;
}

using Names = std::initializer_list<std::string_view>;

// Two arrays that look-ups multiply channel by channel.
void require_pair(const Table& table, const std::string& first, Names first_axes,
                  const std::string& second, Names second_axes) {
    const std::size_t channels = table.array(first).channels();
    table.array(first, std::vector(first_axes), channels);
    table.array(second, std::vector(second_axes), channels);
}

// That look-ups find what they read: of the tables of T01, TransmissionTable sees to it.
void require_shapes(const Table& r_up, const Table& multiple, const Table& conductor,
                    const Table& tir, const Table& mirror, const Table& lobes) {
    for (const std::string side : {"thin_", "dense_"}) {
        require_pair(r_up, side + "maps", {"alpha", "eta"}, side + "absorption", {"tau"});
        require_pair(tir, side + "maps", {"alpha", "eta"}, side + "profile", {"s"});
    }
    require_pair(multiple, "thin_below", {"alpha", "eta"}, "thin_above", {"alpha", "eta"});
    require_pair(multiple, "thin_below", {"alpha", "eta"}, "dense_above", {"alpha", "eta"});
    conductor.array("facets", std::vector<std::string_view>{"alpha"},
                    kConductorTerms * kCoefficients);
    conductor.array("materials", std::vector<std::string_view>{"eta", "kappa"}, kConductorTerms);
    mirror.array("single", std::vector<std::string_view>{"alpha", "cos_theta"}, 1);
    mirror.array("average", std::vector<std::string_view>{"alpha"}, 1);
    mirror.array("equivalent_alpha", std::vector<std::string_view>{"variance"}, 1);
    lobes.array("nodes", std::vector<std::string_view>{"alpha", "cos_theta"}, kLobeNodes + 1);
}

}  // namespace

std::array<Table, kTableNames.size()> read_tables(const std::filesystem::path& folder) {
    std::array<Table, kTableNames.size()> tables;
    for (std::size_t n = 0; n < tables.size(); ++n) {
        const std::filesystem::path file = folder / (std::string{kTableNames[n]} + ".bin");
        tables[n] = read_table(file);
        if (tables[n].name != kTableNames[n])
            throw Error{
                fmt::format("reading table '{}': it holds '{}'", file.string(), tables[n].name)};
    }
    return tables;
}

EnergyTables::EnergyTables(const std::filesystem::path& folder)
    : EnergyTables{read_tables(folder)} {}

EnergyTables::EnergyTables(const std::array<Table, kTableNames.size()>& tables)
    : thin_{tables[0], Contrast::thin},
      dense_{tables[1], Contrast::dense},
      r_up_{tables[2]},
      multiple_{tables[3]},
      conductor_{tables[4]},
      tir_{tables[5]},
      mirror_{tables[6]},
      lobes_{tables[7]} {
    require_shapes(r_up_, multiple_, conductor_, tir_, mirror_, lobes_);
    for (const Table& table : tables) bytes_ += payload_bytes(table);
}

TransmissionProfile EnergyTables::t_down_profile(double alpha, double eta, double tau) const {
    require_interface(alpha, eta);
    require("tau", tau, 0.0, 1.0);
    const bool thin = contrast_of(eta) == Contrast::thin;
    return (thin ? thin_ : dense_).profile(alpha, eta, tau);
}

double EnergyTables::t_down(double cos_theta, double alpha, double eta, double tau) const {
    require("cos_theta", cos_theta, 0.0, 1.0);
    const double cosine = std::clamp(cos_theta, 0.0, 1.0);
    return std::min(t_down_profile(alpha, eta, tau).at(cosine),
                    t_down_profile(alpha, eta, 1.0).at(cosine));
}

DirectionPolynomial EnergyTables::clear_profile(double alpha, double eta) const {
    require_interface(alpha, eta);
    return (contrast_of(eta) == Contrast::thin ? thin_ : dense_).clear_profile(alpha, eta);
}

double EnergyTables::t_up(double alpha, double eta, double tau) const {
    // Reciprocity: T10_bar eta^2 = T01_bar, and a path has the same length both ways.
    const auto average = [&](double transmittance) {
        return t_down_profile(alpha, eta, transmittance).average();
    };
    return std::min(std::min(average(tau), average(1.0)) / (eta * eta), 1.0);
}

double EnergyTables::r_up(double alpha, double eta, double tau) const {
    return (1.0 - t_up(alpha, eta, 1.0)) * r_up_dimming(alpha, eta, tau);
}

double EnergyTables::r_up_dimming(double alpha, double eta, double tau) const {
    require_interface(alpha, eta);
    require("tau", tau, 0.0, 1.0);
    const Contrast contrast = contrast_of(eta);
    const double change = dot(over_two(r_up_.array(prefixed(contrast, "maps")), alpha, eta),
                              over_one(r_up_.array(prefixed(contrast, "absorption")), tau));
    return std::clamp(1.0 + change, 0.0, 1.0);
}

double EnergyTables::variance(double alpha, double eta, double tau) const {
    return t_down_profile(alpha, eta, tau).variance();
}

double EnergyTables::fgd_dielectric(double cos_theta, double alpha, double eta) const {
    return 1.0 - t_down(cos_theta, alpha, eta, 1.0);
}

DirectionPolynomial EnergyTables::fgd_conductor_profile(double alpha, double eta,
                                                        double kappa) const {
    require("alpha", alpha, 0.0, 1.0);
    require("eta", eta, 0.0, 5.0);
    require("kappa", kappa, 0.0, 10.0);
    const std::vector<double> facets = over_one(conductor_.array("facets"), alpha);
    const std::vector<double> material = over_two(conductor_.array("materials"), eta, kappa);
    DirectionPolynomial polynomial;
    for (std::size_t term = 0; term < kConductorTerms; ++term)
        for (std::size_t n = 0; n < kCoefficients; ++n)
            polynomial.above[n] += facets[term * kCoefficients + n] * material[term];
    return polynomial;
}

double EnergyTables::fgd_conductor(double cos_theta, double alpha, double eta, double kappa) const {
    require("cos_theta", cos_theta, 0.0, 1.0);
    const double cosine = std::clamp(cos_theta, 0.0, 1.0);
    return std::clamp(fgd_conductor_profile(alpha, eta, kappa).at(cosine), 0.0, 1.0);
}

double EnergyTables::tir(double cos_theta, double alpha, double eta) const {
    require("cos_theta", cos_theta, 0.0, 1.0);
    require_interface(alpha, eta);
    const Contrast contrast = contrast_of(eta);
    const double value = dot(over_two(tir_.array(prefixed(contrast, "maps")), alpha, eta),
                             over_one(tir_.array(prefixed(contrast, "profile")),
                                      profile_coordinate(std::clamp(cos_theta, 0.0, 1.0), eta)));
    return std::clamp(value, 0.0, 1.0);
}

DirectionPolynomial EnergyTables::fgd_multiple_profile(double alpha, double eta) const {
    require_interface(alpha, eta);
    const Contrast contrast = contrast_of(eta);
    DirectionPolynomial polynomial{critical_cosine(eta), {}, {}};
    polynomial.above = coefficients_of(multiple_.array(prefixed(contrast, "above")), alpha, eta);
    if (contrast == Contrast::thin)
        polynomial.below = coefficients_of(multiple_.array("thin_below"), alpha, eta);
    return polynomial;
}

double EnergyTables::fgd_multiple(double cos_theta, double alpha, double eta) const {
    require("cos_theta", cos_theta, 0.0, 1.0);
    return std::clamp(fgd_multiple_profile(alpha, eta).at(std::clamp(cos_theta, 0.0, 1.0)), 0.0,
                      1.0);
}

double EnergyTables::fgd_multiple_average(double alpha, double eta) const {
    return std::max(2.0 * fgd_multiple_profile(alpha, eta).energy(), 0.0);
}

double EnergyTables::mirror_single(double cos_theta, double alpha) const {
    require("cos_theta", cos_theta, 0.0, 1.0);
    require("alpha", alpha, 0.0, 1.0);
    return over_two(mirror_.array("single"), alpha, cos_theta).front();
}

double EnergyTables::mirror_single_average(double alpha) const {
    require("alpha", alpha, 0.0, 1.0);
    return over_one(mirror_.array("average"), alpha).front();
}

LobeNodes EnergyTables::lobe(double cos_theta, double alpha) const {
    require("cos_theta", cos_theta, 0.0, 1.0);
    require("alpha", alpha, 0.0, 1.0);
    const std::vector<double> channels = over_two(lobes_.array("nodes"), alpha, cos_theta);
    LobeNodes nodes;
    for (std::size_t n = 0; n < kLobeNodes; ++n)
        nodes.cosines[n] = std::clamp(cos_theta + channels[n], 0.0, 1.0);
    nodes.single = channels[kLobeNodes];
    return nodes;
}

double EnergyTables::equivalent_alpha(double variance) const {
    require("variance", variance, 0.0, 0.5);
    return over_one(mirror_.array("equivalent_alpha"), variance).front();
}

}  // namespace lacquer
