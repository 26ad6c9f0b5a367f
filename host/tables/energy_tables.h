// What the baked tables say about light at one rough interface: the reference look-up, in double
// precision with exact linear filtering, of the bytes that shaders read.
// Based on: de Dinechin and Belcour 2022, section 3; Belcour 2018, Eqs. 28-35
//
// Everywhere: cos_theta in [0, 1]; alpha in [0, 1] of GGX facets; eta = ior below / ior above in
// [1/3, 3]; tau in [0, 1], the transmittance of the medium below along its normal. Arguments beyond
// a range throw Error naming it. All orders of scattering are in all values.
#pragma once

#include <filesystem>

#include "tables/table.h"
#include "tables/transmission.h"

namespace lacquer {

// The files, without ".bin", in the order in which they are baked.
inline constexpr std::array<const char*, 8> kTableNames{
    "t_down_thin", "t_down_dense", "r_up", "multiple", "conductor", "tir", "mirror", "lobes"};

// The relative indices that the tables hold: 1/3, as people write it, to 3.
inline constexpr double kMinTableEta = 0.3333, kMaxTableEta = 3.0;

// Reads the files of kTableNames in `folder`; throws Error naming the one that is missing or
// damaged.
std::array<Table, kTableNames.size()> read_tables(const std::filesystem::path& folder);

// Products of a function of the facets and one of the material that fgd_conductor is a sum of.
inline constexpr std::size_t kConductorTerms = 8;

// Light from perfect mirror facets by its direction.
inline constexpr std::size_t kLobeNodes = 7;
struct LobeNodes {
    // Means over seven equal shares of the light, from the flattest up; in [0, 1].
    std::array<double, kLobeNodes> cosines{};
    double single = 1.0;  // the part of the light that has met one facet only
};

class EnergyTables {
 public:
    // See read_tables.
    explicit EnergyTables(const std::filesystem::path& folder);

    // From tables in memory, in the order of kTableNames.
    explicit EnergyTables(const std::array<Table, kTableNames.size()>& tables);

    // T01 as a function of direction, for shading that meets one interface with many lights.
    TransmissionProfile t_down_profile(double alpha, double eta, double tau) const;

    // T01: light arriving at cos_theta from above that enters and crosses the medium. Neither this
    // nor t_up exceeds its value for tau 1.
    double t_down(double cos_theta, double alpha, double eta, double tau) const;

    // t_down for tau 1 as shaders read it: coefficients at the nodes of (alpha, eta), summed over
    // the functions of tau and rounded to half once, and between these interpolated. Within 1e-3 of
    // t_down_profile(alpha, eta, 1).
    DirectionPolynomial clear_profile(double alpha, double eta) const;

    // T10_bar: diffuse light that crosses the medium upwards and leaves.
    double t_up(double alpha, double eta, double tau) const;

    // R10_bar: diffuse light that crosses upwards, is reflected inside and crosses again.
    double r_up(double alpha, double eta, double tau) const;

    // The medium's part of it: r_up over its value for tau 1, whatever that is.
    double r_up_dimming(double alpha, double eta, double tau) const;

    // sigma_2+: variance of the light that leaves, per axis of the projected disk.
    double variance(double alpha, double eta, double tau) const;

    // Light arriving at cos_theta from above that is reflected. From below: eta inverted.
    double fgd_dielectric(double cos_theta, double alpha, double eta) const;

    // The part of it that has met more than one facet, which a single-scattering lobe lacks, as a
    // function of direction: for shading that meets one interface with many lights.
    DirectionPolynomial fgd_multiple_profile(double alpha, double eta) const;

    double fgd_multiple(double cos_theta, double alpha, double eta) const;

    // 2 * integral of fgd_multiple cos dcos over [0, 1].
    double fgd_multiple_average(double alpha, double eta) const;

    // fgd_dielectric for a conductor of relative index eta + i kappa, eta in [0, 5], kappa in [0,
    // 10], as a function of direction: for shading that meets one conductor with many lights. Off
    // by 0.0006 in the mean for kappa >= 0.5; by up to 0.4 for kappa 0 and eta < 1 on smooth
    // facets, where no conductor is: there a critical angle has an edge that it blurs.
    DirectionPolynomial fgd_conductor_profile(double alpha, double eta, double kappa) const;

    // The same at one direction, clamped to [0, 1].
    double fgd_conductor(double cos_theta, double alpha, double eta, double kappa) const;

    // Mean of 1 - F(eta) over the directions into which GGX mirrors of `alpha` reflect light that
    // arrives at cos_theta (single scattering, weighted by energy): what a smooth interface of
    // relative index `eta`, as seen by the light on its way to it, lets through of such a lobe. The
    // TIR term of Belcour 2018, Eq. 33. alpha 0: 1 - F(cos_theta, eta).
    double tir(double cos_theta, double alpha, double eta) const;

    // Light that perfect GGX mirrors reflect at their first facet: what single-scattering models
    // keep, and multiple-scattering compensation fills up to 1.
    double mirror_single(double cos_theta, double alpha) const;

    // 2 * integral of mirror_single cos dcos over [0, 1].
    double mirror_single_average(double alpha) const;

    // Where light arriving at cos_theta goes from perfect GGX mirrors: what meets one facet as
    // mirror_single, and what that lacks of 1 as diffuse light, spread over the hemisphere by its
    // cosine. Means over functions of direction are sums over the nodes. alpha 0: all nodes are
    // cos_theta.
    LobeNodes lobe(double cos_theta, double alpha) const;

    // alpha_2+: roughness of the GGX lobe, of light along the normal, that has this variance per
    // axis of the projected disk; variances of more than a lobe of alpha 1 has give 1.
    double equivalent_alpha(double variance) const;

    // Bytes of the numbers in the files.
    std::size_t bytes() const { return bytes_; }

 private:
    TransmissionTable thin_, dense_;
    Table r_up_, multiple_, conductor_, tir_, mirror_, lobes_;
    std::size_t bytes_ = 0;
};

}  // namespace lacquer
