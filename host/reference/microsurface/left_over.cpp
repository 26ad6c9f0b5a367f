#include "reference/microsurface/left_over.h"

#include <algorithm>
#include <cmath>

#include "reference/fresnel.h"
#include "reference/microsurface/facet_points.h"
#include "reference/microsurface/refraction.h"

namespace lacquer::reference {

namespace {

// One stratum of a side, seen along w.
struct Seen {
    const RoughSide& side;
    const glm::dvec3& w;
    std::size_t k;

    const Facets& facets() const { return side.facets.strata[k].facets; }

    // Of the stratum's area: what sees w and, mirrored by a facet of it, the sky.
    double mirrored_up(const FacetPoint& point) const {
        const glm::dvec3 away = 2.0 * point.cos_theta * point.wm - w;
        return is_above(away) ? masking_shadowing(side.facets, away, w)[k] : 0.0;
    }

    // What sees w and, refracted, the far side.
    double refracted_down(const FacetPoint& point) const {
        const auto away = refracted(w, point.wm, eta_of(side));
        if (!away || away->z >= 0.0) return 0.0;
        return masking_through(side.facets, w, mirrored(*away))[k];
    }
};

// What facets of one stratum send out of the surface; `visible` is what of its area sees w. Their
// reflectances count by what each leaves over.
LeftOver left_by_mirrors(const Seen& seen, double visible) {
    double sent = 0.0, weights = 0.0;
    glm::dvec3 reflectances{0.0};
    const auto leave = [&](const FacetPoint& point, double rest) {
        weights += point.weight * rest;
        const FacetIndex& index = seen.side.index[seen.k];
        for (int c = 0; c < 3; ++c)
            reflectances[c] +=
                point.weight * rest * fresnel(point.cos_theta, index[static_cast<std::size_t>(c)]);
    };
    for_facets_mirroring_up(seen.facets(), seen.w, [&](const FacetPoint& point) {
        const double out = seen.mirrored_up(point);
        sent += point.weight * out;
        leave(point, visible - out);
    });
    for_facets_mirroring_down(seen.facets(), seen.w,
                              [&](const FacetPoint& point) { leave(point, visible); });
    const double met = visible * (1.0 + lambda(seen.facets(), seen.w));
    const double rest = std::clamp(met - sent, 0.0, met);
    return {rest, weights > 0.0 ? rest * reflectances / weights : glm::dvec3{0.0}};
}

// Mirrored as if nothing were let through; and within the cone where facets let light through, that
// instead.
double sent_by_interfaces(const Seen& seen) {
    const double eta = eta_of(seen.side);
    double sent = 0.0;
    const auto mirror = [&](const FacetPoint& point) {
        sent += point.weight * seen.mirrored_up(point);
    };
    const auto refract = [&](const FacetPoint& point) {
        sent += point.weight * (1.0 - fresnel(point.cos_theta, eta)) *
                (seen.refracted_down(point) - seen.mirrored_up(point));
    };
    for_facets_mirroring_up(seen.facets(), seen.w, mirror);
    if (eta < 1.0) {
        for_facets_within(seen.facets(), seen.w, std::sqrt((1.0 - eta) * (1.0 + eta)), refract);
    } else {
        for_facets_mirroring_up(seen.facets(), seen.w, refract);
        for_facets_mirroring_down(seen.facets(), seen.w, refract);
    }
    return sent;
}

}  // namespace

LeftOver left_over(const RoughSide& side, const glm::dvec3& w) {
    LeftOver all;
    if (side.refracts) {
        double sent = 0.0;
        for (std::size_t k = 0; k < side.index.size(); ++k)
            sent += sent_by_interfaces({side, w, k});
        all.met = std::clamp(1.0 - sent, 0.0, 1.0);
        all.kept = glm::dvec3{all.met};
        return all;
    }
    const StratumShares visible = masking(side.facets, w);
    for (std::size_t k = 0; k < visible.size(); ++k) {
        const LeftOver of_stratum = left_by_mirrors({side, w, k}, visible[k]);
        all.met += of_stratum.met;
        all.kept += of_stratum.kept;
    }
    return all;
}

}  // namespace lacquer::reference
