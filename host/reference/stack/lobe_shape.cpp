#include "reference/stack/lobe_shape.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "reference/facets.h"
#include "reference/fresnel.h"
#include "reference/shading.h"
#include "reference/stack/visible_facets.h"

namespace lacquer::reference {

namespace {

constexpr double kExponent = 1.1;  // of Eq. 6
// Of Eq. 10, which says 0.167 at normal incidence and eta 1.5, where simulated light through facets
// of alpha 0.05 to 0.3 is 0.151 to 0.136 as wide as their reflections.
constexpr double kRefractionWidth = 0.85;
constexpr double kMaxAlpha = 0.999;  // whose variance is as good as infinite
// Lobes nearer to grazing have no width to speak of: cosines below are taken at this.
constexpr double kLeastCosine = 0.014;
// Where Snell's law leads to grazing its derivative has no bound: the lobe does.
constexpr double kLeastStretch = 0.1, kMostStretch = 3.0;

double sine_of(double cos_theta) {
    const double cosine = std::clamp(cos_theta, kLeastCosine, 1.0);
    return std::sqrt(1.0 - cosine * cosine);
}

// The mean sine of what the facets refract, each in proportion to what it lets through. What of
// that the surface shadows is scattered again, and no more oblique than if the surface were smooth.
double refracted_sine(const LobeShape& shape, double alpha, double ratio) {
    const double straight = std::min(ratio * shape.sine, sine_of(0.0));
    if (alpha < kMinAlpha) return straight;
    const glm::dvec3 w = direction_of(std::max(cosine_of(shape), kLeastCosine));
    const Facets facets{Ndf::ggx, alpha, alpha};
    double entering = 0.0, light = 0.0, sine = 0.0;
    for (const glm::dvec3& wm : visible_facets(w, alpha)) {
        const double cosine = glm::dot(w, wm);
        const double square = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
        if (square <= 0.0) continue;
        // The refracted direction, mirrored to the side of w.
        const double along = std::sqrt(square) - ratio * cosine;
        const glm::dvec3 wt{ratio * w.x + along * wm.x, along * wm.y, ratio * w.z + along * wm.z};
        if (wt.z <= 0.0) continue;
        const double enters = 1.0 - fresnel(cosine, 1.0 / ratio);
        const double share = enters * masking(facets, wt);
        entering += enters;
        light += share;
        sine += share * wt.x;
    }
    if (light <= 0.0) return straight;
    return std::clamp((sine + (entering - light) * straight) / entering, 0.0, sine_of(0.0));
}

}  // namespace

double cosine_of(const LobeShape& shape) {
    return std::sqrt(std::max(1.0 - shape.sine * shape.sine, 0.0));
}

double variance_of_alpha(double alpha) {
    const double power = std::pow(std::min(alpha, kMaxAlpha), kExponent);
    return power / (1.0 - power);
}

double alpha_of_variance(double variance) {
    return std::pow(variance / (1.0 + variance), 1.0 / kExponent);
}

LobeShape tilted(const LobeShape& shape, double cosine_step) {
    if (cosine_step == 0.0) return shape;
    return {sine_of(cosine_of(shape) + cosine_step), shape.variance};
}

double narrowed(double variance, double spread_ratio) {
    if (spread_ratio >= 1.0) return variance;
    return variance_of_alpha(alpha_of_variance(variance) * std::sqrt(spread_ratio));
}

double reflection_variance(double alpha) {
    return alpha < kMinAlpha ? 0.0 : variance_of_alpha(alpha);
}

Refraction refraction(const LobeShape& shape, double alpha, double ratio) {
    const double sine = refracted_sine(shape, alpha, ratio);
    const double cosine = std::max(std::sqrt(1.0 - sine * sine), kLeastCosine);
    const double stretch = ratio * cosine_of(shape) / cosine;
    // Eq. 10 with cosines as magnitudes: what a tilt of the facet turns the light by, against what
    // it turns a reflection by.
    const double scale = std::min(0.5 * std::abs(1.0 - stretch), 1.0);
    const double width = std::clamp(stretch, kLeastStretch, kMostStretch);
    return {sine, std::pow(width, kExponent),
            reflection_variance(kRefractionWidth * scale * alpha)};
}

double reflection_tilt(const LobeShape& shape, double alpha, double eta) {
    if (alpha < kMinAlpha) return 0.0;
    const glm::dvec3 w = direction_of(std::max(cosine_of(shape), kLeastCosine));
    const Facets facets{Ndf::ggx, alpha, alpha};
    double mirrored = 0.0, mirrored_cosine = 0.0, light = 0.0, cosine = 0.0;
    for (const glm::dvec3& wm : visible_facets(w, alpha)) {
        const double incidence = glm::dot(w, wm);
        const glm::dvec3 wr = 2.0 * incidence * wm - w;
        if (wr.z <= 0.0) continue;
        const double seen = masking(facets, wr);
        const double share = seen * fresnel(incidence, eta);
        mirrored += seen;
        mirrored_cosine += seen * wr.z;
        light += share;
        cosine += share * wr.z;
    }
    return light > 0.0 ? cosine / light - mirrored_cosine / mirrored : 0.0;
}

}  // namespace lacquer::reference
