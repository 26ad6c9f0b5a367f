#include "simulator/microsurface.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "core/error.h"

namespace lacquer::simulator {

namespace {

// A population without roughness inside a blend still needs a finite opacity to be met.
constexpr double kMinBlendAlpha = 1e-4;

// What a walk carries below this share of its start no longer matters beside any noise.
constexpr double kExtinguished = 1e-12;

void check(const Surface& surface) {
    if (surface.strata.empty()) throw Error{"a surface needs at least one stratum of facets"};
    const auto* first = std::get_if<DielectricFacet>(&surface.strata.front().material);
    for (const FacetStratum& stratum : surface.strata) {
        const auto* dielectric = std::get_if<DielectricFacet>(&stratum.material);
        if ((first == nullptr) != (dielectric == nullptr) ||
            (first != nullptr && first->eta != dielectric->eta))
            throw Error{"the strata of a surface must all be dielectric with one eta, or none"};
    }
}

// From the frame of one side to that of the other. The populations are even in slope, so that
// mirroring serves as well as turning over.
Vec3 mirrored(const Vec3& w) {
    return {w.x, w.y, -w.z};
}

FacetStratum turned_over(FacetStratum stratum) {
    if (auto* dielectric = std::get_if<DielectricFacet>(&stratum.material))
        dielectric->eta = 1.0 / dielectric->eta;
    return stratum;
}

}  // namespace

SurfaceWalk::SurfaceWalk(Surface surface) : op_{surface.op} {
    check(surface);
    smooth_ = surface.strata.size() == 1 && surface.strata.front().facets.smooth();
    if (!smooth_)
        for (FacetStratum& stratum : surface.strata) {
            stratum.facets.alpha_x = std::max(stratum.facets.alpha_x, kMinBlendAlpha);
            stratum.facets.alpha_y = std::max(stratum.facets.alpha_y, kMinBlendAlpha);
        }
    above_.strata = surface.strata;
    for (const FacetStratum& stratum : surface.strata)
        below_.strata.push_back(turned_over(stratum));
    std::reverse(below_.strata.begin(), below_.strata.end());
    for (Side* side : {&above_, &below_}) {
        double floor = 1.0;
        for (const FacetStratum& stratum : side->strata)
            side->floor.push_back(floor = std::max(floor - stratum.weight, 0.0));
        side->floor.back() = 0.0;
    }
}

Crossing SurfaceWalk::cross(const Vec3& direction, RandomStream& random, int max_order) const {
    if (smooth_) return cross_smooth(direction, random);
    // In the frame of the side it is on, a ray starts downwards at u = 1 and leaves upwards.
    bool below = direction.z > 0.0;
    Vec3 w = below ? mirrored(direction) : direction;
    double u = 1.0;
    Crossing crossing;
    for (;;) {
        const FacetStratum* stratum = fly(side(below), w, u, random);
        if (stratum == nullptr) break;
        if (crossing.order == max_order) {
            crossing.lost = true;
            break;
        }
        const Vec3 wm = sample_visible_normal(stratum->facets, -w, random);
        const FacetEvent event = meet_facet(stratum->material, w, wm, random);
        crossing.weight *= event.weight;
        ++crossing.order;
        w = event.direction;
        if (event.refracted) {
            below = !below;
            w = mirrored(w);
            u = 1.0 - u;
        }
        if (std::max({crossing.weight.x, crossing.weight.y, crossing.weight.z}) < kExtinguished) {
            crossing.lost = true;
            break;
        }
    }
    crossing.below = below;
    crossing.direction = below ? mirrored(w) : w;
    return crossing;
}

Crossing SurfaceWalk::cross_smooth(const Vec3& direction, RandomStream& random) const {
    const bool from_below = direction.z > 0.0;
    const Vec3 w = from_below ? mirrored(direction) : direction;
    const FacetEvent event =
        meet_facet(side(from_below).strata.front().material, w, Vec3{0.0, 0.0, 1.0}, random);
    Crossing crossing;
    crossing.order = 1;
    crossing.weight = event.weight;
    crossing.below = from_below != event.refracted;
    crossing.direction = from_below ? mirrored(event.direction) : event.direction;
    return crossing;
}

const FacetStratum* SurfaceWalk::fly(const Side& side, const Vec3& direction, double& u,
                                     RandomStream& random) const {
    if (op_ == Blend::Operator::symmetric && side.strata.size() > 1)
        return fly_mixture(side, direction, u, random);
    return fly_layers(side, direction, u, random);
}

const FacetStratum* SurfaceWalk::fly_layers(const Side& side, const Vec3& direction, double& u,
                                            RandomStream& random) const {
    // Optical thickness still to be flown; crossing a stratum of opacity Lambda from u to v takes
    // |Lambda| |log(u / v)| of it.
    double thickness = -std::log(random.uniform());
    std::size_t index = 0;
    while (index + 1 < side.strata.size() && u <= side.floor[index]) ++index;
    if (direction.z < 0.0) {
        for (;; ++index) {
            const double lambda = -smith_lambda(side.strata[index].facets, direction);
            const double floor = side.floor[index];
            const double whole = floor > 0.0 ? lambda * std::log(u / floor) : HUGE_VAL;
            if (thickness < whole) {
                u *= std::exp(-thickness / lambda);
                return &side.strata[index];
            }
            thickness -= whole;
            u = floor;
        }
    }
    for (;; --index) {
        const double lambda = smith_lambda(side.strata[index].facets, direction);
        const double ceiling = index == 0 ? 1.0 : side.floor[index - 1];
        const double whole = lambda * std::log(ceiling / u);
        if (thickness < whole) {
            u *= std::exp(thickness / lambda);
            return &side.strata[index];
        }
        if (index == 0) return nullptr;
        thickness -= whole;
        u = ceiling;
    }
}

const FacetStratum* SurfaceWalk::fly_mixture(const Side& side, const Vec3& direction, double& u,
                                             RandomStream& random) const {
    double lambda = 0.0;
    double facing = 0.0;
    for (const FacetStratum& stratum : side.strata) {
        lambda += stratum.weight * smith_lambda(stratum.facets, direction);
        facing += stratum.weight * projected_area(stratum.facets, -direction);
    }
    const double thickness = -std::log(random.uniform());
    if (direction.z < 0.0) {
        u *= std::exp(thickness / lambda);
    } else {
        if (thickness >= -lambda * std::log(u)) return nullptr;
        u *= std::exp(thickness / lambda);
    }
    // The facet belongs to a population in proportion to the area that it shows to the ray.
    double pick = random.uniform() * facing;
    for (const FacetStratum& stratum : side.strata) {
        pick -= stratum.weight * projected_area(stratum.facets, -direction);
        if (pick <= 0.0) return &stratum;
    }
    return &side.strata.back();
}

}  // namespace lacquer::simulator
