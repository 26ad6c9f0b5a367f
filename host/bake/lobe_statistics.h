// Mean and spread of the lobes of rough surfaces by the simulator, on the projected disk: what
// Belcour 2018 plots to motivate its operators.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "simulator/random.h"
#include "simulator/sampling.h"

namespace lacquer::bake {

// Statistics of directions projected to the disk, x in the plane of incidence.
struct LobeStatistics {
    double energy = 0.0;    // of the light that arrived
    double mean_x = 0.0;    // sine of the mean direction
    double variance = 0.0;  // mean over both axes
};

// One walk: true where it ends in the lobe, whose direction and weight are set then.
using LobeWalk = std::function<bool(simulator::RandomStream&, simulator::Vec3& w, double& weight)>;

LobeStatistics lobe_statistics(const LobeWalk& walk, std::uint64_t walks, std::uint64_t seed);

// Light arriving at sin_theta_i (along +x) that GGX mirrors of alpha reflect at their first facet.
LobeWalk reflected_lobe(double alpha, double sin_theta_i);

// The same reflected again, at normal incidence, by mirrors of alpha_second that face the first.
LobeWalk twice_reflected_lobe(double alpha, double alpha_second);

// Light that passes one facet of a dielectric interface, eta = ior below / ior above; `w` is turned
// to the upper hemisphere.
LobeWalk transmitted_lobe(double alpha, double eta, double sin_theta_i);

// What layers of the given indices and alphas over a conductor of index 1 + i and base_alpha send
// back at normal incidence.
struct LobeLayer {
    double ior, alpha;
};
LobeWalk stack_lobe(const std::vector<LobeLayer>& layers, double base_alpha);

// Maps variances to the alpha of the reflected lobe that has them at normal incidence.
class EquivalentRoughness {
 public:
    EquivalentRoughness(std::uint64_t walks, std::uint64_t seed);

    double operator()(double variance) const;

    // Over alphas n / (size - 1).
    const std::vector<double>& variances() const { return variances_; }

 private:
    std::vector<double> variances_;
};

}  // namespace lacquer::bake
