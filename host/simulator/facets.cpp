#include "simulator/facets.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace lacquer::simulator {

namespace {

constexpr double kPi = std::numbers::pi;

// Squared cosine of a direction exactly along the plane, whose Lambda would be infinite.
constexpr double kMinSquaredCosine = 1e-300;

// Beckmann's Lambda is below 1e-17 for directions steeper than this cot(theta) / alpha.
constexpr double kSteep = 6.0;

// The direction, not normalised, in the space where the population is isotropic with alpha 1.
Vec3 stretch(const Facets& facets, const Vec3& w) {
    return {facets.alpha_x * w.x, facets.alpha_y * w.y, w.z};
}

// GGX facets of alpha 1 are the upper half of a sphere, and those visible from w have normals
// halfway between w and a uniform direction of the cap of z > -w.z. All lengths here are in units
// of 1 / |w|, which saves normalising w.
// Based on: Dupuy and Benyoub 2023, Sampling Visible GGX Normals with Spherical Caps
Vec3 sample_ggx(const Vec3& w, RandomStream& random) {
    const double length = glm::length(w);
    const DiskPoint point = sample_disk(random);
    const double cap = length + w.z;
    const double normal_z = (1.0 - point.squared_radius) * cap;
    const double scale = std::sqrt(cap * (length + normal_z - w.z));
    return {point.x * scale + w.x, point.y * scale + w.y, normal_z};
}

// Slope of a Beckmann facet of alpha 1, along the direction it is seen from and across it.
struct Slope {
    double along, across;
};

// Density proportional to depth exp(-depth^2) beyond `start` >= 0.
double sample_tail(double start, RandomStream& random) {
    return std::sqrt(start * start - std::log(random.uniform()));
}

// Density proportional to max(0, cosine - sine * along) exp(-along^2 - across^2).
//
// Seen from below, the facets are a tail of slopes towards w, drawn by rejection from
// depth exp(-depth^2). From above, +depth and -depth along together have the density of a bell,
// 2 cosine exp(-depth^2), plus that of the tail beyond start = cosine / sine, which is less than
// sine depth exp(-depth^2) and thus in all less than sine exp(-start^2) / 2 <= sine^3 / 2.
Slope sample_beckmann_slope(double cosine, double sine, RandomStream& random) {
    const double start = std::abs(cosine) / sine;
    if (cosine < 0.0) {
        for (;;) {
            const double depth = sample_tail(start, random);
            if (random.uniform() * depth < depth - start)
                return {-depth, sample_bell_pair(random).y};
        }
    }
    const double bell = cosine * std::sqrt(kPi);
    const double tail = 0.5 * sine * sine * sine;
    while (random.uniform() * (bell + tail) >= bell) {
        const double depth = sample_tail(start, random);
        if (random.uniform() * depth * sine * sine < (depth - start) * std::exp(-start * start))
            return {-depth, sample_bell_pair(random).y};
    }
    const BellPair slope = sample_bell_pair(random);
    const double depth = std::abs(slope.x);
    const bool towards_w = random.uniform() * 2.0 * cosine < cosine + sine * depth;
    return {towards_w ? -depth : depth, slope.y};
}

Vec3 sample_beckmann(const Vec3& w, RandomStream& random) {
    const double sine = std::sqrt(w.x * w.x + w.y * w.y);
    const double length = glm::length(w);
    const double cos_phi = sine > 0.0 ? w.x / sine : 1.0;
    const double sin_phi = sine > 0.0 ? w.y / sine : 0.0;
    const Slope slope = sample_beckmann_slope(w.z / length, sine / length, random);
    return {sin_phi * slope.across - cos_phi * slope.along,
            -sin_phi * slope.along - cos_phi * slope.across, 1.0};
}

double lambda_above(Ndf ndf, double squared_tangent) {
    if (ndf == Ndf::ggx) return 0.5 * (std::sqrt(1.0 + squared_tangent) - 1.0);
    const double a = 1.0 / std::sqrt(squared_tangent);
    if (a > kSteep) return 0.0;
    return std::exp(-a * a) / (2.0 * a * std::sqrt(kPi)) - 0.5 * std::erfc(a);
}

}  // namespace

double smith_lambda(const Facets& facets, const Vec3& w) {
    const Vec3 stretched = stretch(facets, w);
    const double squared_sine = stretched.x * stretched.x + stretched.y * stretched.y;
    const double above =
        lambda_above(facets.ndf, squared_sine / std::max(w.z * w.z, kMinSquaredCosine));
    return w.z >= 0.0 ? above : -1.0 - above;
}

double projected_area(const Facets& facets, const Vec3& w) {
    return w.z * (1.0 + smith_lambda(facets, w));
}

double normal_density(const Facets& facets, const Vec3& wm) {
    if (wm.z <= 0.0) return 0.0;
    const double slope_x = wm.x / (facets.alpha_x * wm.z);
    const double slope_y = wm.y / (facets.alpha_y * wm.z);
    const double squared_slope = slope_x * slope_x + slope_y * slope_y;
    const double fall = facets.ndf == Ndf::ggx
                            ? 1.0 / ((1.0 + squared_slope) * (1.0 + squared_slope))
                            : std::exp(-squared_slope);
    const double cos2 = wm.z * wm.z;
    return fall / (kPi * facets.alpha_x * facets.alpha_y * cos2 * cos2);
}

Vec3 sample_visible_normal(const Facets& facets, const Vec3& w, RandomStream& random) {
    const Vec3 stretched = stretch(facets, w);
    const Vec3 normal =
        facets.ndf == Ndf::ggx ? sample_ggx(stretched, random) : sample_beckmann(stretched, random);
    return glm::normalize(Vec3{facets.alpha_x * normal.x, facets.alpha_y * normal.y, normal.z});
}

}  // namespace lacquer::simulator
