// What the tables' quantities are made of, and who can walk it.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "bake/dielectric.h"
#include "bake/mirror.h"

namespace lacquer::bake {

// Conductors by their relative index, with the curves that the walks of this folder look up.
struct Conductors {
    struct Index {
        double eta, kappa;
    };

    explicit Conductors(std::vector<Index> all);

    std::vector<Index> indices;
    FresnelCurves curves;
};

// Estimates over GGX facets of alpha in [0, 1], with as many walks each as the source was made for;
// ranges and meaning as in dielectric.h and mirror.h. Different seeds give independent noise.
class Walks {
 public:
    virtual ~Walks() = default;

    // Recorded in the tables: the backend whose kernels walk; empty for the walks of this folder.
    virtual std::string_view backend() const = 0;

    // Whether several threads may ask at once.
    virtual bool concurrent() const = 0;

    // One per cosine.
    virtual std::vector<CosineHistogram> light_entering(std::span<const double> cosines,
                                                        double alpha, double eta,
                                                        std::uint64_t seed) const = 0;

    // One per cosine.
    virtual std::vector<double> light_reflected_again(std::span<const double> cosines, double alpha,
                                                      double eta, std::uint64_t seed) const = 0;

    virtual DiffuseExits light_leaving(double alpha, double eta, std::uint64_t seed) const = 0;

    // One per conductor.
    virtual std::vector<double> reflected_by_conductors(double cos_theta, double alpha,
                                                        const Conductors& conductors,
                                                        std::uint64_t seed) const = 0;

    virtual double reflected_once(double cos_theta, double alpha, std::uint64_t seed) const = 0;

    // One per cosine.
    virtual std::vector<double> lobe_transmittances(std::span<const double> cosines, double alpha,
                                                    double eta, std::uint64_t seed) const = 0;
};

// The walks of this folder, driven by low-discrepancy points: the least noise.
class HostWalks final : public Walks {
 public:
    explicit HostWalks(std::size_t samples) : points_{samples} {}

    std::string_view backend() const override { return {}; }
    bool concurrent() const override { return true; }
    std::vector<CosineHistogram> light_entering(std::span<const double> cosines, double alpha,
                                                double eta, std::uint64_t seed) const override;
    std::vector<double> light_reflected_again(std::span<const double> cosines, double alpha,
                                              double eta, std::uint64_t seed) const override;
    DiffuseExits light_leaving(double alpha, double eta, std::uint64_t seed) const override;
    std::vector<double> reflected_by_conductors(double cos_theta, double alpha,
                                                const Conductors& conductors,
                                                std::uint64_t seed) const override;
    double reflected_once(double cos_theta, double alpha, std::uint64_t seed) const override;
    std::vector<double> lobe_transmittances(std::span<const double> cosines, double alpha,
                                            double eta, std::uint64_t seed) const override;

 private:
    SobolPoints points_;
};

}  // namespace lacquer::bake
