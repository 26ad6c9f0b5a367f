#include "study/layered/operators/lobes.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "reference/facets.h"
#include "reference/shading.h"
#include "study/even_point.h"

namespace lacquer::study {

namespace {

constexpr int kLobePoints = 2048;  // widths to about a hundredth of them

simulator::SurfaceWalk surface_of(Ndf ndf, double alpha, const simulator::FacetMaterial& facet) {
    return simulator::SurfaceWalk{
        simulator::Surface{Blend::Operator::asymmetric, {{1.0, {ndf, alpha, alpha}, facet}}}};
}

}  // namespace

simulator::SurfaceWalk mirrors(Ndf ndf, double alpha) {
    // An imaginary index absorbs nothing.
    return surface_of(ndf, alpha, simulator::ConductorFacet{Rgb{}, {10.0, 10.0, 10.0}});
}

simulator::SurfaceWalk dielectric(double alpha, double eta) {
    return surface_of(Ndf::ggx, alpha, simulator::DielectricFacet{eta});
}

Ray lobe_ray(double alpha, double cosine, int n, int count) {
    const glm::dvec3 w{-std::sqrt(1.0 - cosine * cosine), 0.0, cosine};
    const reference::Facets facets{Ndf::ggx, alpha, alpha};
    const glm::dvec3 point = even_point(n);
    const glm::dvec3 wm = reference::sample_visible_normal(facets, w, {(n + 0.5) / count, point.x});
    const glm::dvec3 wi = 2.0 * glm::dot(w, wm) * wm - w;
    if (wi.z <= 0.0) return {};
    return {wi, reference::masking_shadowing(facets, wi, w) / reference::masking(facets, w)};
}

Spread ggx_lobe(double alpha, double cosine) {
    const double at = std::clamp(alpha, reference::kMinAlpha, 1.0);
    DiskMoments moments;
    for (int n = 0; n < kLobePoints; ++n) {
        const Ray ray = lobe_ray(at, cosine, n, kLobePoints);
        if (ray.weight > 0.0) moments.add(ray.weight, ray.direction);
    }
    return moments.spread(kLobePoints);
}

}  // namespace lacquer::study
