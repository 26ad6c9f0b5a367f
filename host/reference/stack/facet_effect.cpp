#include "reference/stack/facet_effect.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "reference/facets.h"
#include "reference/fresnel.h"
#include "reference/shading.h"
#include "reference/stack/directions.h"

namespace lacquer::reference {

namespace {

// Where the sampling square of visible normals is looked at: as good as hundreds of points (the
// albedos of stacks change by less than 0.001). The other half of all azimuths mirrors this one.
constexpr std::array<glm::dvec2, 4> kVisible{
    {{0.125, 0.25}, {0.375, 0.25}, {0.125, 0.75}, {0.375, 0.75}}};

// Of Eq. 10, which says 0.167 at normal incidence and eta 1.5, where simulated light through facets
// of alpha 0.05 to 0.3 is 0.151 to 0.136 as wide as their reflections.
constexpr double kRefractionWidth = 0.85;
// Where Snell's law leads to grazing its derivative has no bound: the lobe does.
constexpr double kLeastStretch = 0.1, kMostStretch = 3.0;
constexpr double kLeastWidth = 0.5, kMostWidth = 2.0;  // that few points can tell
constexpr double kTiny = 1e-9;

// Moments of directions on the projected disk.
struct Moments {
    double light = 0.0, cosine = 0.0, along = 0.0, square = 0.0;

    void add(const glm::dvec3& w, double weight) {
        light += weight;
        cosine += weight * w.z;
        along += weight * w.x;
        square += weight * (w.x * w.x + w.y * w.y);
    }

    double mean_cosine() const { return cosine / light; }
    double spread() const {
        const double mean = along / light;
        return std::max(square / light - mean * mean, kTiny);
    }
};

// The mean of sqrt(max(x, 0)) over a width of 2 h about x, without differences of like numbers.
double mean_root(double x, double h) {
    const double high = std::sqrt(std::max(x + h, 0.0)), low = std::sqrt(std::max(x - h, 0.0));
    const double share = std::clamp((x + h) / h, 0.0, 2.0) / 3.0;
    return share * (high * high + high * low + low * low) / std::max(high + low, kTiny);
}

// What one of few facets does in place of all those near it: at the critical angle, where the
// Fresnel equations follow a square root, that root's mean.
struct FacetRefraction {
    double reflectance;
    double cosine;  // to the facet's normal, of what is refracted
};

// `h`: half the width over which the squares of incident cosines are spread.
FacetRefraction refraction_near(double incidence, double eta, double h) {
    const double square = eta * eta - (1.0 - incidence * incidence);
    if (eta >= 1.0) return {fresnel(incidence, eta), std::sqrt(square) / eta};
    const double g = mean_root(square, h);
    const auto amplitude = [&](double kept) { return (kept - g) / std::max(kept + g, kTiny); };
    const double s = amplitude(incidence), p = amplitude(eta * eta * incidence);
    return {g > 0.0 ? std::min(0.5 * (s * s + p * p), 1.0) : 1.0, g / eta};
}

// Of what lies about each of these normals: half as wide as all are apart.
double spread_of_incidence(const glm::dvec3& w, const std::array<glm::dvec3, 4>& normals) {
    glm::dvec4 squares;
    for (int n = 0; n < 4; ++n) squares[n] = std::pow(std::min(glm::dot(w, normals[n]), 1.0), 2);
    const glm::dvec4 steps = squares - glm::dot(squares, glm::dvec4{0.25});
    return std::max(std::sqrt(0.1875 * glm::dot(steps, steps)), kTiny);
}

double other(double sine_or_cosine) {
    return std::sqrt(std::max(1.0 - sine_or_cosine * sine_or_cosine, 0.0));
}

double straight_sine(const glm::dvec3& w, double eta) {
    return std::min(w.x / eta, kMostSine);
}

}  // namespace

FacetEffect facet_effect(double cosine, double alpha, double eta) {
    const glm::dvec3 w = direction_of(std::max(cosine, alpha < kMinAlpha ? 0.0 : kLeastCosine));
    FacetEffect effect;
    effect.refracted_sine = effect.crossing_sine = straight_sine(w, eta);
    if (alpha < kMinAlpha) return effect;
    const Facets facets{Ndf::ggx, alpha, alpha};
    Moments mirrored, reflected;
    double entering = 0.0;
    Moments refracted;
    std::array<glm::dvec3, kVisible.size()> normals;
    std::ranges::transform(kVisible, normals.begin(), [&](const glm::dvec2& u) {
        return sample_visible_normal(facets, w, u);
    });
    const double h = spread_of_incidence(w, normals);
    const auto seen_at = [&](double z) { return masking(facets, direction_of(std::min(z, 1.0))); };
    for (const glm::dvec3& wm : normals) {
        const double incidence = std::min(glm::dot(w, wm), 1.0);
        const auto [reflectance, transmitted] = refraction_near(incidence, eta, h);
        const glm::dvec3 wr = 2.0 * incidence * wm - w;
        if (wr.z > 0.0) {
            const double seen = seen_at(wr.z);
            mirrored.add(wr, seen);
            reflected.add(wr, seen * reflectance);
        }
        // The refracted direction, mirrored to the side of w; a mean, and so not quite a unit
        // vector.
        const double along = transmitted - incidence / eta;
        const glm::dvec3 wt{w.x / eta + along * wm.x, along * wm.y, w.z / eta + along * wm.z};
        const double share = wt.z > 0.0 ? (1.0 - reflectance) * seen_at(wt.z) : 0.0;
        entering += 1.0 - reflectance;
        refracted.add(wt, share);
    }
    if (reflected.light > kTiny) {
        effect.reflected_tilt = reflected.mean_cosine() - mirrored.mean_cosine();
        effect.reflected_width =
            std::clamp(std::sqrt(reflected.spread() / mirrored.spread()), kLeastWidth, kMostWidth);
    }
    // What the surface shadows is scattered again, and no more oblique than if it were smooth.
    if (refracted.light > kTiny) {
        const double straight = effect.refracted_sine, shadowed = entering - refracted.light;
        const double sine = (refracted.along + shadowed * straight) / entering;
        const double mean_cosine = (refracted.cosine + shadowed * other(straight)) / entering;
        effect.refracted_sine = std::clamp(sine, 0.0, kMostSine);
        effect.crossing_sine =
            eta < 1.0 ? effect.refracted_sine
                      : std::min(0.5 * (std::max(sine, 0.0) + other(mean_cosine)), kMostSine);
    }
    return effect;
}

RefractedRoughness refracted_roughness(double cosine, double refracted_cosine, double alpha,
                                       double eta) {
    const double stretch = cosine / (eta * std::max(refracted_cosine, kLeastCosine));
    const double turn = std::min(0.5 * std::abs(1.0 - stretch), 1.0);
    const double added = kRefractionWidth * turn * alpha;
    const double most = refracted_cosine * refracted_cosine;
    return {std::clamp(stretch, kLeastStretch, kMostStretch),
            added / std::sqrt(1.0 + added * added / (most * most))};
}

}  // namespace lacquer::reference
