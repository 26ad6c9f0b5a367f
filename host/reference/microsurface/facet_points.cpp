#include "reference/microsurface/facet_points.h"

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>

namespace lacquer::reference {

namespace {

using std::numbers::pi;

// Towards w and away from it, each.
constexpr unsigned kQuarterAzimuths = 4;
// Where the azimuths end at the cone of the critical angle.
constexpr unsigned kConeAzimuths = 4;
constexpr unsigned kHeights = 6;
constexpr unsigned kSteepHeights = 2;

// at(x, weight) for Gauss and Legendre's points of an integral from low to high.
template <unsigned Count, typename At>
void for_points_between(double low, double high, const At& at) {
    using Rule = boost::math::quadrature::gauss<double, Count>;
    const double middle = 0.5 * (low + high), half = 0.5 * (high - low);
    for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
        const double offset = half * Rule::abscissa()[i], weight = half * Rule::weights()[i];
        at(middle - offset, weight);
        if (offset > 0.0) at(middle + offset, weight);
    }
}

// Slopes in polar coordinates, in units of alpha: the radius is tan(x), and a height tan(x / 2), of
// which GGX is a rational function; 1 is a vertical facet.
double height_of(double steepness) {
    return std::isinf(steepness) ? 1.0 : steepness / (1.0 + std::hypot(1.0, steepness));
}

// Beyond, at a slope of 2.9 alpha, Beckmann's distribution has nothing left that counts, and points
// there would be wasted.
constexpr double kBeckmannHeight = 0.71;

// Facets whose slope is along one azimuth.
struct Ray {
    glm::dvec2 unit;  // slope of the facet of steepness 1
    double length;
    double along;  // cosine between its azimuth and w

    Ray(const Facets& facets, const glm::dvec3& w, const glm::dvec2& azimuth)
        : unit{facets.alpha_x * azimuth.x, facets.alpha_y * azimuth.y},
          length{glm::length(unit)},
          along{glm::dot(unit, glm::dvec2{w.x, w.y}) / length} {}

    double height(double slope) const { return height_of(slope / length); }

    // Of facets that mirror w to the horizon.
    double horizon(const glm::dvec3& w) const {
        const double root = std::hypot(along, w.z);
        return height(along > 0.0 ? (along + root) / w.z : w.z / (root - along));
    }

    // Of facets that w grazes.
    double grazed(const glm::dvec3& w) const { return along < 0.0 ? height(-w.z / along) : 1.0; }
};

template <unsigned Count>
void for_heights(const Facets& facets, const glm::dvec3& w, const Ray& ray, double azimuth_weight,
                 double low, double most, const AtFacetPoint& at) {
    const double high = facets.ndf == Ndf::beckmann ? std::min(most, kBeckmannHeight) : most;
    if (!(high > low)) return;
    for_points_between<Count>(low, high, [&](double y, double weight) {
        const double flatness = (1.0 - y) * (1.0 + y);
        const double steepness = 2.0 * y / flatness;
        const glm::dvec3 slope{steepness * ray.unit, 1.0};
        const double facing = glm::dot(w, slope);
        if (facing <= 0.0) return;
        const double area = steepness * 2.0 * (1.0 + y * y) / (flatness * flatness);
        at({glm::normalize(slope), facing / glm::length(slope),
            weight * azimuth_weight * area * slope_density(facets.ndf, steepness) * facing / w.z});
    });
}

// The azimuth of w is x or y; the half of the azimuths beside it counts twice.
glm::dvec2 azimuth_beside(const glm::dvec3& w, double cosine, double sine) {
    return w.y == 0.0 ? glm::dvec2{cosine, sine} : glm::dvec2{sine, cosine};
}

template <typename AtRay>
void for_rays(const Facets& facets, const glm::dvec3& w, const AtRay& at) {
    for (const double quarter : {0.0, 0.5 * pi})
        for_points_between<kQuarterAzimuths>(
            quarter, quarter + 0.5 * pi, [&](double psi, double weight) {
                at(Ray{facets, w, azimuth_beside(w, std::cos(psi), std::sin(psi))}, 2.0 * weight);
            });
}

void for_heights_within(const Facets& facets, const glm::dvec3& w, double critical_cosine,
                        const Ray& ray, double azimuth_weight, const AtFacetPoint& at) {
    // The facet of this azimuth that faces w most; and tangents of the sum and the difference of
    // its tilt and what the cone leaves about it.
    const double beyond = std::sqrt(
        std::max(ray.along * ray.along + w.z * w.z - critical_cosine * critical_cosine, 0.0));
    const double above = ray.along * critical_cosine - w.z * beyond;
    const double low =
        above > 0.0 ? ray.height(above / (w.z * critical_cosine + ray.along * beyond)) : 0.0;
    const double across = w.z * critical_cosine - ray.along * beyond;
    const double high =
        across > 0.0 ? ray.height((ray.along * critical_cosine + w.z * beyond) / across) : 1.0;
    for_heights<kHeights>(facets, w, ray, azimuth_weight, low, high, at);
}

}  // namespace

void for_facets_mirroring_up(const Facets& facets, const glm::dvec3& w, const AtFacetPoint& at) {
    for_rays(facets, w, [&](const Ray& ray, double weight) {
        for_heights<kHeights>(facets, w, ray, weight, 0.0, ray.horizon(w), at);
    });
}

void for_facets_mirroring_down(const Facets& facets, const glm::dvec3& w, const AtFacetPoint& at) {
    for_rays(facets, w, [&](const Ray& ray, double weight) {
        for_heights<kSteepHeights>(facets, w, ray, weight, ray.horizon(w), ray.grazed(w), at);
    });
}

void for_facets_within(const Facets& facets, const glm::dvec3& w, double critical_cosine,
                       const AtFacetPoint& at) {
    if (w.z >= critical_cosine) {
        for_rays(facets, w, [&](const Ray& ray, double weight) {
            for_heights_within(facets, w, critical_cosine, ray, weight, at);
        });
        return;
    }
    // Azimuths within the cone have a cosine to w of at least `least`, to the side of w alone.
    const double least = std::sqrt((critical_cosine - w.z) * (critical_cosine + w.z));
    const double most = std::hypot(w.x, w.y);
    const bool is_x = w.y == 0.0;
    const double alpha = is_x ? facets.alpha_x : facets.alpha_y;
    const double other = is_x ? facets.alpha_y : facets.alpha_x;
    // tan^2 of the stretched azimuth where the cone ends.
    const double tangent2 = (most - least) * (most + least) * alpha * alpha /
                            std::max(least * least * other * other, 1e-300);
    if (!(tangent2 > 0.0)) return;
    // In t = tan(psi / 2), whose cosine and sine are rational.
    const double root = std::sqrt(1.0 + tangent2);
    const double last = std::sqrt((root - 1.0) / (root + 1.0));
    for_points_between<kConeAzimuths>(0.0, last, [&](double t, double weight) {
        const double whole = 1.0 + t * t;
        const glm::dvec2 azimuth =
            azimuth_beside(w, (1.0 - t) * (1.0 + t) / whole, 2.0 * t / whole);
        for_heights_within(facets, w, critical_cosine, Ray{facets, w, azimuth},
                           4.0 * weight / whole, at);
    });
}

}  // namespace lacquer::reference
