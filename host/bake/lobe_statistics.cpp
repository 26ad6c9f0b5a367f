#include "bake/lobe_statistics.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "simulator/estimator.h"
#include "simulator/microsurface.h"
#include "simulator/stack.h"

namespace lacquer::bake {

namespace {

using simulator::RandomStream;
using simulator::SurfaceWalk;
using simulator::Vec3;

struct LobeTally {
    double weight = 0.0, x = 0.0, squared_radius = 0.0;
    std::uint64_t count = 0;

    void merge(const LobeTally& other) {
        weight += other.weight;
        x += other.x;
        squared_radius += other.squared_radius;
    }
};

SurfaceWalk surface_of(double alpha, const simulator::FacetMaterial& material) {
    return SurfaceWalk{{Blend::Operator::asymmetric, {{1.0, {Ndf::ggx, alpha, alpha}, material}}}};
}

// Index 0 + 0 i reflects everything.
SurfaceWalk mirrors(double alpha) {
    return surface_of(alpha, simulator::ConductorFacet{});
}

Vec3 arriving_at(double sin_theta_i) {
    return {sin_theta_i, 0.0, -std::sqrt(1.0 - sin_theta_i * sin_theta_i)};
}

}  // namespace

LobeStatistics lobe_statistics(const LobeWalk& walk, std::uint64_t walks, std::uint64_t seed) {
    simulator::RunOptions options;
    options.samples = walks;
    options.seed = seed;
    const auto tally =
        simulator::run_walks<LobeTally>(options, [&](RandomStream& random, LobeTally& sum) {
            Vec3 w;
            double weight = 1.0;
            if (!walk(random, w, weight)) return;
            sum.weight += weight;
            sum.x += weight * w.x;
            sum.squared_radius += weight * (w.x * w.x + w.y * w.y);
        });
    if (tally.weight <= 0.0) return {};
    const double mean = tally.x / tally.weight;
    return {tally.weight / static_cast<double>(tally.count), mean,
            0.5 * (tally.squared_radius / tally.weight - mean * mean)};
}

LobeWalk reflected_lobe(double alpha, double sin_theta_i) {
    return [surface = mirrors(alpha), arriving = arriving_at(sin_theta_i)](RandomStream& random,
                                                                           Vec3& w, double&) {
        const auto crossing = surface.cross(arriving, random, 1);
        w = crossing.direction;
        return !crossing.lost;
    };
}

LobeWalk twice_reflected_lobe(double alpha, double alpha_second) {
    return [first = mirrors(alpha), second = mirrors(alpha_second)](RandomStream& random, Vec3& w,
                                                                    double&) {
        const auto once = first.cross({0.0, 0.0, -1.0}, random, 1);
        if (once.lost) return false;
        const auto twice = second.cross(simulator::mirrored(once.direction), random, 1);
        w = twice.direction;
        return !twice.lost;
    };
}

LobeWalk transmitted_lobe(double alpha, double eta, double sin_theta_i) {
    return [surface = surface_of(alpha, simulator::DielectricFacet{eta}),
            arriving = arriving_at(sin_theta_i)](RandomStream& random, Vec3& w, double&) {
        const auto crossing = surface.cross(arriving, random, 1);
        w = simulator::mirrored(crossing.direction);
        return !crossing.lost && crossing.below;
    };
}

LobeWalk stack_lobe(const std::vector<LobeLayer>& layers, double base_alpha) {
    Material material;
    for (const LobeLayer& layer : layers)
        material.layers.push_back(
            {{layer.ior, Microsurface{Ndf::ggx, {layer.alpha, layer.alpha}}}, AbsorbingMedium{}});
    material.base = ConductorBase{
        {1.0, 1.0, 1.0}, {1.0, 1.0, 1.0}, Microsurface{Ndf::ggx, {base_alpha, base_alpha}}};
    const auto stack = std::make_shared<const simulator::StackWalk>(material);
    return [stack](RandomStream& random, Vec3& w, double& weight) {
        const simulator::Exit exit = stack->walk({0.0, 0.0, 1.0}, random);
        w = exit.direction;
        weight = exit.weight.x;
        return exit.fate == simulator::Fate::direct || exit.fate == simulator::Fate::base;
    };
}

EquivalentRoughness::EquivalentRoughness(std::uint64_t walks, std::uint64_t seed) {
    constexpr int kNodes = 41;
    for (int n = 0; n < kNodes; ++n) {
        const double alpha = static_cast<double>(n) / (kNodes - 1);
        variances_.push_back(lobe_statistics(reflected_lobe(alpha, 0.0), walks, seed).variance);
    }
}

double EquivalentRoughness::operator()(double variance) const {
    const auto above = std::lower_bound(variances_.begin(), variances_.end(), variance);
    if (above == variances_.begin()) return 0.0;
    if (above == variances_.end()) return 1.0;
    const auto index = static_cast<double>(above - variances_.begin());
    const double share = (variance - above[-1]) / (*above - above[-1]);
    return (index - 1.0 + share) / static_cast<double>(variances_.size() - 1);
}

}  // namespace lacquer::bake
