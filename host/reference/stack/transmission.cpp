#include "reference/stack/transmission.h"

#include <algorithm>
#include <cmath>

#include "reference/reflection.h"
#include "reference/shading.h"
#include "reference/stack/directions.h"
#include "reference/stack/lobe_width.h"

namespace lacquer::reference {

namespace {

Facets facets_of(const TransmissionLobe& lobe) {
    return {Ndf::ggx, lobe.alpha, lobe.alpha};
}

glm::dvec3 turned(const glm::dvec3& w) {
    return {w.x, w.y, -w.z};
}

// The direction of this cosine in the azimuth of w; along the normal that is x.
glm::dvec3 turned_to(const glm::dvec3& w, double cosine) {
    const double sine = std::hypot(w.x, w.y);
    const glm::dvec3 along = direction_of(cosine);
    if (sine <= 0.0) return along;
    return {along.x * w.x / sine, along.x * w.y / sine, along.z};
}

}  // namespace

TransmissionLobe transmission_lobe(const Beam& arrived, const glm::dvec3& wo,
                                   const EnergyTables& tables) {
    const double cosine = std::clamp(arrived.cosine, kLeastCosine, 1.0);
    const double alpha = std::clamp(arrived.alpha(), kMinAlpha, 1.0);
    return {glm::dvec3{arrived.energy()}, alpha, tables.lobe(cosine, alpha).single,
            turned_to(wo, cosine)};
}

glm::dvec3 transmission_value(const TransmissionLobe& lobe, const glm::dvec3& wi) {
    return lobe.energy / lobe.mirrored * reflection_lobe(facets_of(lobe), turned(wi), lobe.from);
}

double transmission_pdf(const TransmissionLobe& lobe, const glm::dvec3& wi) {
    return reflection_pdf(facets_of(lobe), turned(wi), lobe.from);
}

glm::dvec3 transmission_sample(const TransmissionLobe& lobe, const glm::dvec2& u) {
    return turned(reflection_sample(facets_of(lobe), lobe.from, u));
}

}  // namespace lacquer::reference
