#include "simulator/surface_side.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lacquer::simulator {

namespace {

// Highest place of a facet, for flights so short that they round to none: from the other side it is
// the lowest, and finite.
constexpr double kHighest = -1e-300;

double sample_optical_thickness(RandomStream& random) {
    return -std::log(random.uniform());
}

}  // namespace

SurfaceSide::SurfaceSide(Blend::Operator op, std::vector<FacetStratum> strata)
    : op_{op}, strata_{std::move(strata)} {
    double below = 1.0;
    for (const FacetStratum& stratum : strata_) {
        below -= stratum.weight;
        floor_.push_back(std::log(std::max(below, 0.0)));
    }
    floor_.back() = -HUGE_VAL;
}

std::size_t SurfaceSide::stratum_at(double z) const {
    std::size_t index = 0;
    while (z <= floor_[index]) ++index;
    return index;
}

const FacetStratum* SurfaceSide::fly(const Vec3& w, double& z, RandomStream& random) const {
    double thickness = sample_optical_thickness(random);
    if (mixed()) {
        const double lambda = mixed_lambda(w);
        if (w.z >= 0.0 && thickness >= -lambda * z) return nullptr;
        z += thickness / lambda;
        return &pick_facing(-w, random);
    }
    // Crossing a stratum from z to its end takes |Lambda| per unit of z of the thickness.
    std::size_t index = stratum_at(z);
    if (w.z < 0.0) {
        for (;; ++index) {
            const double lambda = smith_lambda(strata_[index].facets, w);
            const double whole = lambda * (floor_[index] - z);
            if (thickness < whole) {
                z += thickness / lambda;
                return &strata_[index];
            }
            thickness -= whole;
            z = floor_[index];
        }
    }
    for (;; --index) {
        const double lambda = smith_lambda(strata_[index].facets, w);
        const double whole = lambda * (ceiling(index) - z);
        if (thickness < whole) {
            z += thickness / lambda;
            return &strata_[index];
        }
        if (index == 0) return nullptr;
        thickness -= whole;
        z = ceiling(index);
    }
}

double SurfaceSide::escape(const Vec3& w, double z) const {
    if (w.z <= 0.0) return 0.0;
    if (mixed()) return std::exp(mixed_lambda(w) * z);
    double thickness = 0.0;
    for (std::size_t index = 0; index <= stratum_at(z); ++index) {
        const double from = std::max(z, floor_[index]);
        thickness += smith_lambda(strata_[index].facets, w) * (ceiling(index) - from);
    }
    return std::exp(-thickness);
}

double SurfaceSide::mixed_lambda(const Vec3& w) const {
    double lambda = 0.0;
    for (const FacetStratum& stratum : strata_)
        lambda += stratum.weight * smith_lambda(stratum.facets, w);
    return lambda;
}

// The facet belongs to a population in proportion to the area that it shows to w.
const FacetStratum& SurfaceSide::pick_facing(const Vec3& w, RandomStream& random) const {
    double facing = 0.0;
    for (const FacetStratum& stratum : strata_)
        facing += stratum.weight * projected_area(stratum.facets, w);
    double pick = random.uniform() * facing;
    const FacetStratum* picked = &strata_.front();
    for (const FacetStratum& stratum : strata_) {
        const double area = stratum.weight * projected_area(stratum.facets, w);
        if (area <= 0.0) continue;
        picked = &stratum;
        pick -= area;
        if (pick <= 0.0) break;
    }
    return *picked;
}

double turned_over(double z) {
    return std::log(-std::expm1(std::min(z, kHighest)));
}

}  // namespace lacquer::simulator
