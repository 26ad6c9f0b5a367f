#include "reference/stack/visible_facets.h"

#include <algorithm>
#include <cmath>

#include "reference/facets.h"

namespace lacquer::reference {

VisibleFacets visible_facets(const glm::dvec3& w, double alpha) {
    VisibleFacets normals;
    const Facets facets{Ndf::ggx, alpha, alpha};
    for (std::size_t n = 0; n < normals.size(); ++n) {
        const double azimuth = static_cast<double>(n % kFacetAzimuths) + 0.5;
        const double height = static_cast<double>(n / kFacetAzimuths) + 0.5;
        normals[n] = sample_visible_normal(facets, w,
                                           {azimuth / (2.0 * static_cast<double>(kFacetAzimuths)),
                                            height / static_cast<double>(kFacetHeights)});
    }
    return normals;
}

glm::dvec3 direction_of(double cos_theta) {
    return {std::sqrt(std::max(1.0 - cos_theta * cos_theta, 0.0)), 0.0, cos_theta};
}

}  // namespace lacquer::reference
