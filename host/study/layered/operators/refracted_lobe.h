// A ray that rough facets refract, and the reflections that stand for what becomes of it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "simulator/estimator.h"
#include "study/layered/operators/lobes.h"

namespace lacquer::study {

// Light at `cosine` and GGX facets of index `eta` = ior of the other medium / ior of the light's.
struct Refraction {
    double cosine, alpha, eta;
};

// By Snell's law, of smooth facets; at most 1.
double refracted_sine(const Refraction& at);

// The mean that stack gives it.
double stack_refracted_sine(const Refraction& at);

// The ray after it has crossed the facets.
class RefractedRays {
 public:
    explicit RefractedRays(const Refraction& at);
    Ray operator()(simulator::RandomStream& random) const;

 private:
    simulator::SurfaceWalk surface_;
    glm::dvec3 direction_;
};

// A GGX reflection about the mirror direction of light at this sine.
struct FakeLobe {
    double alpha, sine;

    // Kept from grazing, where lobes have no width to speak of.
    double cosine() const;
};

struct FakeLobeModel {
    std::string name;
    std::function<FakeLobe(const Refraction& at)> lobe;
};

// Of stack and by the paper's formulas.
std::vector<FakeLobeModel> fake_lobes();

}  // namespace lacquer::study
