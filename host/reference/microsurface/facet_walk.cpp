#include "reference/microsurface/facet_walk.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "reference/fresnel.h"
#include "reference/microsurface/refraction.h"

namespace lacquer::reference {

namespace {

// Cosine of a ray along the surface, whose Lambda would be infinite.
constexpr double kMinCosine = 1e-12;

// Depth of a facet at the very top, which is infinitely deep from the other side.
constexpr double kMinDepth = 1e-300;

// w or its mirror image, whichever is above the surface.
glm::dvec3 upper(const glm::dvec3& w) {
    return {w.x, w.y, std::max(std::abs(w.z), kMinCosine)};
}

bool is_mixed(const FacetStrata& surface) {
    return surface.op == Blend::Operator::symmetric;
}

double rate(double lambda, const glm::dvec3& w) {
    return w.z < 0.0 ? 1.0 + lambda : lambda;
}

// Area of the facets that face v, per unit of macroscopic area: v may be below the surface.
double facing_area(const Facets& facets, const glm::dvec3& v) {
    return std::max(std::abs(v.z), kMinCosine) * rate(lambda(facets, upper(v)), -v);
}

// Depth of the lower end of each stratum.
std::vector<double> floors_of(const FacetStrata& surface) {
    std::vector<double> floors;
    double below = 1.0;
    for (const FacetStratum& stratum : surface.strata) {
        below -= stratum.weight;
        floors.push_back(-std::log(std::max(below, 0.0)));
    }
    floors.back() = HUGE_VAL;
    return floors;
}

// By the area that each population shows to v; u in [0, 1).
std::size_t facing_stratum(const FacetStrata& surface, const glm::dvec3& v, double u) {
    std::vector<double> areas;
    double all = 0.0;
    for (const FacetStratum& stratum : surface.strata) {
        areas.push_back(stratum.weight * facing_area(stratum.facets, v));
        all += areas.back();
    }
    std::size_t k = 0;
    for (double before = areas[0]; k + 1 < areas.size() && u * all >= before; before += areas[k])
        ++k;
    return k;
}

bool fly_mixed(const FacetStrata& surface, FacetRay& ray, double thickness, double u) {
    const double rate_here = rate(lambda(surface, upper(ray.w)), ray.w);
    if (ray.w.z >= 0.0 && thickness >= rate_here * ray.depth) return false;
    ray.depth += (ray.w.z < 0.0 ? thickness : -thickness) / rate_here;
    ray.stratum = facing_stratum(surface, -ray.w, u);
    return true;
}

std::size_t stratum_at(const std::vector<double>& floors, double depth) {
    std::size_t k = 0;
    while (depth > floors[k]) ++k;
    return k;
}

bool fly_down(const FacetStrata& surface, FacetRay& ray, double thickness) {
    const std::vector<double> floors = floors_of(surface);
    for (std::size_t k = stratum_at(floors, ray.depth);; ++k) {
        const double rate_here = 1.0 + lambda(surface.strata[k].facets, upper(ray.w));
        const double whole = rate_here * (floors[k] - ray.depth);
        if (thickness < whole) {
            ray.depth += thickness / rate_here;
            ray.stratum = k;
            return true;
        }
        thickness -= whole;
        ray.depth = floors[k];
    }
}

bool fly_up(const FacetStrata& surface, FacetRay& ray, double thickness) {
    const std::vector<double> floors = floors_of(surface);
    for (std::size_t k = stratum_at(floors, ray.depth);; --k) {
        const double rate_here = lambda(surface.strata[k].facets, upper(ray.w));
        const double ceiling = k == 0 ? 0.0 : floors[k - 1];
        const double whole = rate_here * (ray.depth - ceiling);
        if (thickness < whole) {
            ray.depth -= thickness / rate_here;
            ray.stratum = k;
            return true;
        }
        if (k == 0) return false;
        thickness -= whole;
        ray.depth = ceiling;
    }
}

glm::dvec3 reflectance(const FacetIndex& index, double cos_theta) {
    return {fresnel(cos_theta, index[0]), fresnel(cos_theta, index[1]),
            fresnel(cos_theta, index[2])};
}

// A ray that was refracted, in the frame of its new side.
void turn_over(const TwoSides& sides, FacetRay& ray) {
    ray.w = mirrored(ray.w);
    ray.depth = turned_depth(ray.depth);
    ray.stratum = sides[ray.side].facets.strata.size() - 1 - ray.stratum;
    ray.side = 1 - ray.side;
}

}  // namespace

FacetRay entering(const glm::dvec3& w) {
    return {-w};
}

bool fly(const TwoSides& sides, FacetRay& ray, const glm::dvec2& u) {
    const FacetStrata& surface = sides[ray.side].facets;
    const double thickness = -std::log1p(-u.x);
    if (is_mixed(surface)) return fly_mixed(surface, ray, thickness, u.y);
    return ray.w.z < 0.0 ? fly_down(surface, ray, thickness) : fly_up(surface, ray, thickness);
}

double escape(const RoughSide& side, const glm::dvec3& w, double depth) {
    const FacetStrata& surface = side.facets;
    if (is_mixed(surface)) return std::exp(-depth * lambda(surface, upper(w)));
    const std::vector<double> floors = floors_of(surface);
    double thickness = 0.0;
    for (std::size_t k = 0; k <= stratum_at(floors, depth); ++k)
        thickness += lambda(surface.strata[k].facets, upper(w)) *
                     (std::min(depth, floors[k]) - (k == 0 ? 0.0 : floors[k - 1]));
    return std::exp(-thickness);
}

double turned_depth(double depth) {
    return -std::log(-std::expm1(-std::max(depth, kMinDepth)));
}

glm::dvec3 turn(const TwoSides& sides, FacetRay& ray, const glm::dvec3& u) {
    const RoughSide& side = sides[ray.side];
    const glm::dvec3 v = -ray.w;
    const glm::dvec3 wm =
        sample_visible_normal(side.facets.strata[ray.stratum].facets, v, {u.x, u.y});
    const double cos_theta = std::clamp(glm::dot(v, wm), 0.0, 1.0);
    if (side.refracts && u.z >= fresnel(cos_theta, eta_of(side))) {
        // At the critical angle rounding may leave nothing to refract: it goes along the facet.
        ray.w = refracted(v, wm, eta_of(side)).value_or(glm::normalize(cos_theta * wm - v));
        turn_over(sides, ray);
        return glm::dvec3{1.0};
    }
    ray.w = glm::normalize(2.0 * cos_theta * wm - v);
    return side.refracts ? glm::dvec3{1.0} : reflectance(side.index[ray.stratum], cos_theta);
}

Connection connection(const TwoSides& sides, const FacetRay& ray, const glm::dvec3& w,
                      std::size_t target) {
    const RoughSide& side = sides[ray.side];
    const Facets& facets = side.facets.strata[ray.stratum].facets;
    const glm::dvec3 v = -ray.w;
    const double area = facing_area(facets, v);
    if (!(area > 0.0)) return {};
    if (target == ray.side) {
        const glm::dvec3 wm = glm::normalize(v + w);
        const double cos_theta = glm::dot(v, wm);
        if (!(wm.z > 0.0 && cos_theta > 0.0)) return {};
        // The visible density / (4 dot(v, wm)), where the dot product cancels.
        const double sent = escape(side, w, ray.depth) * density(facets, wm) / (4.0 * area);
        if (side.refracts) return {sent * fresnel(std::min(cos_theta, 1.0), eta_of(side))};
        return {sent, reflectance(side.index[ray.stratum], std::min(cos_theta, 1.0))};
    }
    const auto wm = refraction_halfway(mirrored(w), v, eta_of(side));
    if (!wm) return {};
    const double cos_theta = std::min(glm::dot(v, *wm), 1.0);
    return {escape(sides[target], w, turned_depth(ray.depth)) *
            (1.0 - fresnel(cos_theta, eta_of(side))) * density(facets, *wm) * cos_theta / area *
            refraction_jacobian(mirrored(w), v, *wm, eta_of(side))};
}

FacetRay reversed(const FacetRay& ray) {
    return {-ray.w, ray.depth, ray.side, ray.stratum};
}

}  // namespace lacquer::reference
