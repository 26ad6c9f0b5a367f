#include "simulator/interface.h"

#include <algorithm>
#include <cmath>

namespace lacquer::simulator {

namespace {

struct InterfaceTally {
    Moments t_down, fgd, r_up, t_up;
    Moments squared_radius;  // of the light that leaves, weighted by what it carries
    double radius_product = 0.0;
    std::uint64_t count = 0;

    void merge(const InterfaceTally& other) {
        t_down.merge(other.t_down);
        fgd.merge(other.fgd);
        r_up.merge(other.r_up);
        t_up.merge(other.t_up);
        squared_radius.merge(other.squared_radius);
        radius_product += other.radius_product;
    }
};

// Transmittance of one crossing of the medium along `direction`.
double crossing_transmittance(double tau, const Vec3& direction) {
    return tau == 1.0 ? 1.0 : std::pow(tau, 1.0 / std::abs(direction.z));
}

void enter(const SurfaceWalk& surface, double tau, const Vec3& direction, RandomStream& random,
           InterfaceTally& tally) {
    const Crossing crossing = surface.cross(direction, random);
    if (crossing.lost) return;
    if (crossing.below) {
        tally.t_down.add(crossing_transmittance(tau, crossing.direction));
    } else {
        tally.fgd.add(1.0);
    }
}

void leave(const SurfaceWalk& surface, double tau, RandomStream& random, InterfaceTally& tally) {
    const Vec3 upwards = sample_cosine(random);
    const Crossing crossing = surface.cross(upwards, random);
    if (crossing.lost) return;
    const double up = crossing_transmittance(tau, upwards);
    if (crossing.below) {
        tally.r_up.add(up * crossing_transmittance(tau, crossing.direction));
        return;
    }
    const Vec3& w = crossing.direction;
    const double spread = up * (w.x * w.x + w.y * w.y);
    tally.t_up.add(up);
    tally.squared_radius.add(spread);
    tally.radius_product += up * spread;
}

Estimate estimate(const Moments& moments, double count) {
    return {moments.mean(count), moments.standard_error(count)};
}

// Half the mean squared radius of the light that leaves, a ratio of two sums: its error to first
// order.
Estimate variance_of(const InterfaceTally& tally) {
    if (tally.t_up.sum <= 0.0) return {};
    const double ratio = tally.squared_radius.sum / tally.t_up.sum;
    const double residual = tally.squared_radius.squares - 2.0 * ratio * tally.radius_product +
                            ratio * ratio * tally.t_up.squares;
    return {0.5 * ratio, 0.5 * std::sqrt(std::max(0.0, residual)) / tally.t_up.sum};
}

}  // namespace

InterfaceEstimate estimate_interface(const Facets& facets, double eta, double tau, double cos_theta,
                                     const RunOptions& options) {
    const SurfaceWalk surface{
        Surface{Blend::Operator::asymmetric, {{1.0, facets, DielectricFacet{eta}}}}};
    const Vec3 downwards{std::sqrt(1.0 - cos_theta * cos_theta), 0.0, -cos_theta};
    const auto tally =
        run_walks<InterfaceTally>(options, [&](RandomStream& random, InterfaceTally& sum) {
            enter(surface, tau, downwards, random, sum);
            leave(surface, tau, random, sum);
        });
    const auto count = static_cast<double>(tally.count);
    InterfaceEstimate result;
    result.t_down = estimate(tally.t_down, count);
    result.fgd = estimate(tally.fgd, count);
    result.r_up = estimate(tally.r_up, count);
    result.t_up = estimate(tally.t_up, count);
    result.variance = variance_of(tally);
    result.samples = tally.count;
    return result;
}

}  // namespace lacquer::simulator
