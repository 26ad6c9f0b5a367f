#include "reference/microsurface/visible_normals.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace lacquer::reference {

namespace {

// The greatest number below 1.
constexpr double kBelowOne = 0x1.fffffffffffffp-1;

// Keeps the quotient finite where rounding chooses a hidden stratum.
constexpr double kLeast = 1e-300;

}  // namespace

double visible_density(const FacetStrata& surface, const glm::dvec3& w, const glm::dvec3& wm) {
    const StratumShares visible = masking(surface, w);
    double sum = 0.0;
    for (std::size_t k = 0; k < visible.size(); ++k)
        sum += visible[k] * density(surface.strata[k].facets, wm);
    return sum * std::max(glm::dot(w, wm), 0.0) / w.z;
}

VisibleNormal sample_visible_normal(const FacetStrata& surface, const glm::dvec3& w,
                                    const glm::dvec3& u) {
    const StratumShares first = first_met(surface, w);
    const std::size_t last = first.size() - 1;
    std::size_t k = 0;
    double below = 0.0;  // sum of the probabilities of the strata before k
    double probability = 1.0;
    for (;; ++k) {
        probability = first[k];
        if (k == last || u.x < below + probability) break;
        below += probability;
    }
    const double rest = std::clamp((u.x - below) / std::max(probability, kLeast), 0.0, kBelowOne);
    return {k, sample_visible_normal(surface.strata[k].facets, w, {u.y, u.z}), rest};
}

}  // namespace lacquer::reference
