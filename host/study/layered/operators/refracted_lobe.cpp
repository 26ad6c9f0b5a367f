#include "study/layered/operators/refracted_lobe.h"

#include <algorithm>
#include <cmath>

#include "reference/stack/facet_effect.h"
#include "reference/stack/published/operators_2018.h"

namespace lacquer::study {

namespace {

namespace published = reference::published_2018;

constexpr double kMostSine = 0.999;

double other(double sine_or_cosine) {
    return std::sqrt(std::max(1.0 - sine_or_cosine * sine_or_cosine, 0.0));
}

FakeLobe stack_lobe(const Refraction& at) {
    const double sine = stack_refracted_sine(at);
    return {reference::refracted_roughness(at.cosine, other(sine), at.alpha, at.eta).added, sine};
}

// A roughness of `scale` times that of the facets, about the refracted direction.
template <typename Scale>
FakeLobeModel scaled(const char* name, const Scale& scale) {
    return {name, [=](const Refraction& at) {
                const double sine = refracted_sine(at);
                return FakeLobe{scale(at.cosine, other(sine), at.eta) * at.alpha, sine};
            }};
}

}  // namespace

double refracted_sine(const Refraction& at) {
    return published::refracted_sine(other(at.cosine), at.eta);
}

double stack_refracted_sine(const Refraction& at) {
    return reference::facet_effect(at.cosine, at.alpha, at.eta).refracted_sine;
}

RefractedRays::RefractedRays(const Refraction& at)
    : surface_{dielectric(at.alpha, at.eta)}, direction_{downwards(at.cosine)} {}

Ray RefractedRays::operator()(simulator::RandomStream& random) const {
    const auto crossing = surface_.cross(direction_, random);
    return {crossing.direction, crossing.below ? 1.0 : 0.0};
}

double FakeLobe::cosine() const {
    return other(std::min(sine, kMostSine));
}

std::vector<FakeLobeModel> fake_lobes() {
    return {{"stack", stack_lobe},
            scaled("2018", published::refraction_scale),
            scaled("as printed", published::refraction_scale_as_printed),
            scaled("equal peaks",
                   [](double, double, double eta) { return published::peak_scale(eta); })};
}

}  // namespace lacquer::study
