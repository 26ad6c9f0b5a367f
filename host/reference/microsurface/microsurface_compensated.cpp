#include "reference/microsurface/microsurface_compensated.h"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <numbers>

namespace lacquer::reference {

namespace {

using std::numbers::pi;

// The greatest number below 1.
constexpr double kBelowOne = 0x1.fffffffffffffp-1;

// What is known of light along wo on the side it is on.
struct Viewer {
    const SeveralFacetsSide* near_side;
    const SeveralFacetsSide* far_side;
    SeveralShares shares;
    double reflected, through;  // probabilities of the directions of several facets
};

// w in the frame of its own side.
glm::dvec3 upright(const glm::dvec3& w) {
    return is_below(w) ? mirrored(w) : w;
}

const SeveralFacetsSide& side_of(const SeveralFacets& several, const glm::dvec3& w) {
    return is_below(w) ? several.below : several.above;
}

Viewer viewer_of(const SeveralFacets& several, const glm::dvec3& wo) {
    const SeveralFacetsSide& near_side = side_of(several, wo);
    const SeveralShares shares = several_shares(several.turning, near_side, upright(wo));
    return {&near_side, &side_of(several, -wo), shares, mean(shares.reflected), shares.through};
}

// f of what met several facets, without what the medium below absorbs.
glm::dvec3 several_eval(const CompensatedMicrosurface& surface, const glm::dvec3& wi,
                        const Viewer& viewer, bool is_same_side) {
    const SeveralFacetsSide& side = is_same_side ? *viewer.near_side : *viewer.far_side;
    const SeveralShares from = several_shares(surface.several.turning, side, upright(wi));
    return is_same_side ? several_reflected(side, from, viewer.shares)
                        : glm::dvec3{several_through(side, from, viewer.shares)};
}

// What a medium of transmittance `tau` leaves of the diffuse lobe of `m`, averaged over azimuths,
// between which m only turns.
template <typename Share>
double crossed(const Share& m, double tau) {
    if (tau == 1.0) return 1.0;
    using Quadrature = boost::math::quadrature::gauss_kronrod<double, 31>;
    constexpr unsigned kMaxHalvings = 6;
    constexpr double kTolerance = 1e-8;
    const auto light = [&](double x) {
        const double sine = std::sqrt((1.0 - x * x) * (1.0 + x * x));
        double sum = 0.0;
        constexpr int kAzimuths = 16;
        for (int n = 0; n < kAzimuths; ++n) {
            const double phi = 2.0 * pi * (n + 0.5) / kAzimuths;
            sum += m({sine * std::cos(phi), sine * std::sin(phi), x * x});
        }
        return 4.0 * x * x * x * sum;
    };
    const auto left = [&](double x) {
        return x > 0.0 ? light(x) * std::pow(tau, 1.0 / (x * x)) : 0.0;
    };
    const double all = Quadrature::integrate(light, 0.0, 1.0, kMaxHalvings, kTolerance);
    if (all <= 0.0) return 1.0;
    return Quadrature::integrate(left, 0.0, 1.0, kMaxHalvings, kTolerance) / all;
}

}  // namespace

CompensatedMicrosurface prepare_microsurface_compensated(const Material& material) {
    const RoughSurface surface = rough_surface(material, Model::microsurface_compensated);
    CompensatedMicrosurface prepared{{surface}, several_facets(surface)};
    if (!surface.below) return prepared;
    const auto shares = [&](const glm::dvec3& w) {
        return several_shares(prepared.several.turning, prepared.several.below, w);
    };
    for (int c = 0; c < 3; ++c) {
        prepared.crossed_reflected[c] =
            crossed([&](const glm::dvec3& w) { return shares(w).reflected.x; }, surface.tau[c]);
        prepared.crossed_through[c] =
            crossed([&](const glm::dvec3& w) { return shares(w).through; }, surface.tau[c]);
    }
    return prepared;
}

glm::dvec3 eval(const CompensatedMicrosurface& surface, const glm::dvec3& wi,
                const glm::dvec3& wo) {
    const Turned at = turned(surface.single, wi, wo);
    if (!at.side || at.wi.z == 0.0 || (is_below(at.wi) && !at.side->refracts))
        return glm::dvec3{0.0};
    const glm::dvec3 crossings = crossing(surface.single, wi) * crossing(surface.single, wo);
    return eval(surface.single, wi, wo) +
           crossings * several_eval(surface, wi, viewer_of(surface.several, wo), is_above(at.wi));
}

double pdf(const CompensatedMicrosurface& surface, const glm::dvec3& wi, const glm::dvec3& wo) {
    const Turned at = turned(surface.single, wi, wo);
    if (!at.side) return 0.0;
    const Viewer viewer = viewer_of(surface.several, wo);
    const double diffuse = is_above(at.wi) ? viewer.reflected : viewer.through;
    return (1.0 - viewer.reflected - viewer.through) * pdf(surface.single, wi, wo) +
           diffuse * std::abs(wi.z) / pi;
}

Sample sample(const CompensatedMicrosurface& surface, const glm::dvec3& wo, const glm::dvec3& u) {
    Sample chosen;
    const Turned at = turned(surface.single, {}, wo);
    if (!at.side) return chosen;
    const Viewer viewer = viewer_of(surface.several, wo);
    const double several = viewer.reflected + viewer.through;
    glm::dvec3 wi;  // in the frame of wo
    if (u.x < several) {
        const glm::dvec3 diffuse = sample_cosine({u.y, u.z});
        wi = u.x < viewer.reflected ? diffuse : mirrored(diffuse);
    } else {
        const double rest = std::min((u.x - several) / (1.0 - several), kBelowOne);
        const FacetSample facet = sample_facet(*at.side, at.wo, {rest, u.y, u.z});
        chosen.wi = is_above(wo) ? facet.wi : mirrored(facet.wi);
        if (facet.is_lost) return chosen;
        wi = facet.wi;
    }
    chosen.wi = is_above(wo) ? wi : mirrored(wi);
    chosen.pdf = pdf(surface, chosen.wi, wo);
    if (chosen.pdf > 0.0)
        chosen.weight = eval(surface, chosen.wi, wo) * std::abs(chosen.wi.z) / chosen.pdf;
    return chosen;
}

Albedo albedo(const CompensatedMicrosurface& surface, const glm::dvec3& wo) {
    Albedo light = albedo(surface.single, wo);
    if (!turned(surface.single, {}, wo).side) return light;
    const Viewer viewer = viewer_of(surface.several, wo);
    const glm::dvec3 before = crossing(surface.single, wo);
    glm::dvec3 reflected = before * viewer.shares.reflected;
    glm::dvec3 through = before * viewer.shares.through;
    if (is_below(wo))
        reflected *= surface.crossed_reflected;
    else
        through *= surface.crossed_through;
    if (surface.single.below) {
        light.direct += reflected;
        light.transmitted += through;
    } else {
        light.base += reflected;
    }
    return light;
}

}  // namespace lacquer::reference
