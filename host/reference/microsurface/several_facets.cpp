#include "reference/microsurface/several_facets.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>

#include "reference/fresnel.h"
#include "reference/microsurface/left_over.h"

namespace lacquer::reference {

namespace {

// Averages below this are nothing: m is then next to 0 but near grazing, where its polynomial has
// few nodes, and would be divided by what rounding leaves of it elsewhere.
constexpr double kLeastAverage = 3e-4;

// Keeps quotients of averages finite.
constexpr double kLeast = 1e-9;

// A ray that has met a second facet leaves with the probability 1 minus these times what the first
// left over, of its direction and on average: fitted to walks over random conductors.
constexpr double kKeptByDirection = 0.4;
constexpr double kKeptOnAverage = 0.3;

// The second facet reflects half like the first facets of this direction, which may be of another
// metal than most, and half like those of all directions: fitted likewise.
constexpr double kLikeTheFirst = 0.5;

// m of GGX facets turns between the planes as roughnesses would whose ratio is this much closer to
// 0: fitted to the closed form of light that met one facet, 0.06 to 0.9 by 0.15 to 1.
constexpr double kGgxTurning = 0.36;

// How many times more, at cos_theta, the plane of the greater roughness counts at 45 degrees than
// the other: 1 over this. At normal incidence it counts as much, at grazing by the roughnesses.
double turning_of(const Turning& turning, double cos_theta) {
    const double cos2 = cos_theta * cos_theta;
    const double scale = kGgxTurning + (1.0 - kGgxTurning) * turning.beckmann_share;
    const double square = cos2 + (1.0 - cos2) * scale * turning.alpha2_ratio;
    return std::sqrt(square) * (1.0 - turning.beckmann_share) + square * turning.beckmann_share;
}

// What the plane of x counts for at w.
double share_of_xz(const Turning& turning, const glm::dvec3& w) {
    const double lesser = turning_of(turning, w.z);
    const double x = w.x * w.x * (turning.is_rougher_along_x ? 1.0 : lesser);
    const double y = w.y * w.y * (turning.is_rougher_along_x ? lesser : 1.0);
    return x + y > 0.0 ? x / (x + y) : 0.5;
}

// The same averaged over the azimuths.
double mean_share_of_xz(const Turning& turning, double cos_theta) {
    const double root = std::sqrt(turning_of(turning, cos_theta));
    return (turning.is_rougher_along_x ? 1.0 : root) / (1.0 + root);
}

Turning turning_of(const FacetStrata& surface) {
    double x = 0.0, y = 0.0, beckmann = 0.0;
    for (const FacetStratum& stratum : surface.strata) {
        x += stratum.weight * stratum.facets.alpha_x * stratum.facets.alpha_x;
        y += stratum.weight * stratum.facets.alpha_y * stratum.facets.alpha_y;
        if (stratum.facets.ndf == Ndf::beckmann) beckmann += stratum.weight;
    }
    return {x >= y, std::min(x, y) / std::max(x, y), beckmann};
}

bool is_isotropic(const FacetStrata& surface) {
    return std::ranges::all_of(surface.strata, [](const FacetStratum& stratum) {
        return stratum.facets.alpha_x == stratum.facets.alpha_y;
    });
}

using AtNodes = std::array<glm::dvec3, kAlbedoNodes>;

// A quantity in both planes, and its average over all directions.
struct InPlanes {
    AtNodes xz, yz;

    glm::dvec3 average(const Turning& turning) const {
        AtNodes over_azimuths;
        for (std::size_t n = 0; n < kAlbedoNodes; ++n)
            over_azimuths[n] =
                glm::mix(yz[n], xz[n], mean_share_of_xz(turning, albedo_node_cosine(n)));
        return glm::max(albedo_fit(over_azimuths).average(), glm::dvec3{0.0});
    }
};

struct LeftInPlanes {
    InPlanes met, kept;
};

LeftInPlanes left_in_planes(const RoughSide& side) {
    LeftInPlanes left;
    const bool is_turned = !is_isotropic(side.facets);
    for (std::size_t n = 0; n < kAlbedoNodes; ++n) {
        const double cosine = albedo_node_cosine(n);
        const double sine = std::sqrt((1.0 - cosine) * (1.0 + cosine));
        const LeftOver in_xz = left_over(side, {sine, 0.0, cosine});
        const LeftOver in_yz = is_turned ? left_over(side, {0.0, sine, cosine}) : in_xz;
        left.met.xz[n] = glm::dvec3{in_xz.met};
        left.met.yz[n] = glm::dvec3{in_yz.met};
        left.kept.xz[n] = in_xz.kept;
        left.kept.yz[n] = in_yz.kept;
    }
    return left;
}

// What finally leaves of `kept` light, by a series of facets that are all alike after the second.
struct Leaving {
    double met_average;
    glm::dvec3 reflectance;  // on average

    glm::dvec3 operator()(const glm::dvec3& met, const glm::dvec3& kept) const {
        if (met.x <= 0.0) return glm::dvec3{0.0};
        const double leaves = 1.0 - kKeptByDirection * met.x - kKeptOnAverage * met_average;
        const glm::dvec3 second = glm::mix(reflectance, kept / met.x, kLikeTheFirst);
        return kept * second * leaves / (1.0 - reflectance * (1.0 - leaves));
    }
};

SeveralFacetsSide side_of_mirrors(const RoughSide& side, const Turning& turning) {
    const LeftInPlanes left = left_in_planes(side);
    const double met = left.met.average(turning).x;
    if (met < kLeastAverage) return {};
    const Leaving leaving{met, left.kept.average(turning) / met};
    InPlanes m;
    for (std::size_t n = 0; n < kAlbedoNodes; ++n) {
        m.xz[n] = leaving(left.met.xz[n], left.kept.xz[n]);
        m.yz[n] = leaving(left.met.yz[n], left.kept.yz[n]);
    }
    return {albedo_fit(m.xz), albedo_fit(m.yz), 0.0, 0.0, m.average(turning), 0.0};
}

// Averaged over cosine-weighted directions.
double average_fresnel(double eta) {
    const auto f = [&](double cosine) { return 2.0 * cosine * fresnel(cosine, eta); };
    return boost::math::quadrature::gauss<double, 20>::integrate(f, 0.0, 1.0);
}

// A quarter of the mean reflectance is what is reflected of light that met several facets from the
// side of the lower index, fitted to walks over random interfaces: most of it met two, and is let
// through by the one or the other.
constexpr double kReflectedAgain = 0.25;

struct Averages {
    double m;
    double with_cosine;  // of m cos_theta
};

Averages averages_of(const InPlanes& m, const Turning& turning) {
    InPlanes with_cosine = m;
    for (std::size_t n = 0; n < kAlbedoNodes; ++n) {
        with_cosine.xz[n] *= albedo_node_cosine(n);
        with_cosine.yz[n] *= albedo_node_cosine(n);
    }
    return {m.average(turning).x, with_cosine.average(turning).x};
}

SeveralFacetsSide side_of_interface(const InPlanes& m, const Averages& averages, double at_grazing,
                                    double slope) {
    const double through = at_grazing * averages.m + slope * averages.with_cosine;
    return {albedo_fit(m.xz), albedo_fit(m.yz), at_grazing, slope, glm::dvec3{averages.m - through},
            through};
}

// The part let through is the same from everywhere on the side of the lower index, and in
// proportion to the cosine on the other, or less steep where all would not be enough: as much light
// crosses either way, for radiance over the square of the index.
void divide(const InPlanes& thin, const InPlanes& dense, const Turning& turning, double eta,
            SeveralFacetsSide& thin_side, SeveralFacetsSide& dense_side) {
    const Averages of_thin = averages_of(thin, turning);
    const Averages of_dense = averages_of(dense, turning);
    if (of_thin.m < kLeastAverage || of_dense.m < kLeastAverage) return;
    const double index2 = eta * eta;
    const double wanted = 1.0 - kReflectedAgain * average_fresnel(eta);
    const double through = std::min(wanted, index2 * of_dense.m / of_thin.m);
    const double crossing = through * of_thin.m / index2;  // on average, from the dense side
    const double slope = crossing / std::max(of_dense.with_cosine, kLeast);
    thin_side = side_of_interface(thin, of_thin, through, 0.0);
    if (slope <= 1.0) {
        dense_side = side_of_interface(dense, of_dense, 0.0, slope);
    } else {
        const double flatter = std::clamp(
            (of_dense.m - crossing) / std::max(of_dense.m - of_dense.with_cosine, kLeast), 0.0,
            1.0);
        dense_side = side_of_interface(dense, of_dense, 1.0 - flatter, flatter);
    }
}

}  // namespace

SeveralFacets several_facets(const RoughSurface& surface) {
    SeveralFacets several{turning_of(surface.above.facets), {}, {}};
    if (!surface.is_there) return several;
    if (!surface.below) {
        several.above = side_of_mirrors(surface.above, several.turning);
        return several;
    }
    const double eta = eta_of(surface.above);
    const InPlanes above = left_in_planes(surface.above).met;
    const InPlanes below = left_in_planes(*surface.below).met;
    if (eta > 1.0)
        divide(above, below, several.turning, eta, several.above, several.below);
    else
        divide(below, above, several.turning, 1.0 / eta, several.below, several.above);
    return several;
}

SeveralShares several_shares(const Turning& turning, const SeveralFacetsSide& side,
                             const glm::dvec3& w) {
    const double x = share_of_xz(turning, w);
    const glm::dvec3 m = glm::clamp(glm::mix(side.in_yz.at(w.z), side.in_xz.at(w.z), x), 0.0, 1.0);
    const double through = side.through_at_grazing + side.through_slope * w.z;
    return {m * (1.0 - through), m.x * through};
}

glm::dvec3 several_reflected(const SeveralFacetsSide& side, const SeveralShares& from,
                             const SeveralShares& to) {
    glm::dvec3 f{0.0};
    for (int c = 0; c < 3; ++c)
        if (side.average_reflected[c] > kLeast)
            f[c] = from.reflected[c] * to.reflected[c] /
                   (std::numbers::pi * side.average_reflected[c]);
    return f;
}

double several_through(const SeveralFacetsSide& far_side, const SeveralShares& from,
                       const SeveralShares& to) {
    if (far_side.average_through <= kLeast) return 0.0;
    return from.through * to.through / (std::numbers::pi * far_side.average_through);
}

}  // namespace lacquer::reference
