// A rough surface seen from one side: a half space whose opacity depends on height.
// Based on: Heitz et al. 2016, Multiple-Scattering Microfacet BSDFs with the Smith Model;
//           d'Eon et al. 2023, microsurfaces with non-uniform statistics
//
// Height is measured by z = log C(h) <= 0, C the fraction of the surface below h: 0 is the top, and
// uniform facets have the constant optical thickness |Lambda(w)| per unit of z. The logarithm keeps
// its digits at both ends.
#pragma once

#include <vector>

#include "simulator/facet_material.h"
#include "simulator/facets.h"

namespace lacquer::simulator {

struct FacetStratum {
    double weight = 1.0;  // of the surface's area; all strata together 1
    Facets facets;
    FacetMaterial material;
};

class SurfaceSide {
 public:
    // At least one stratum. asymmetric: strata from the top down, each its share of C; symmetric:
    // mixed at every height.
    SurfaceSide(Blend::Operator op, std::vector<FacetStratum> strata);

    // Flies from height z along w to the next facet, or out of the top: the stratum of the facet,
    // or nullptr above the surface. Updates z.
    const FacetStratum* fly(const Vec3& w, double& z, RandomStream& random) const;

    // Probability that a ray leaves from height z along w without meeting a facet; 0 downwards.
    double escape(const Vec3& w, double z) const;

    const std::vector<FacetStratum>& strata() const { return strata_; }

 private:
    bool mixed() const { return op_ == Blend::Operator::symmetric && strata_.size() > 1; }
    double mixed_lambda(const Vec3& w) const;
    const FacetStratum& pick_facing(const Vec3& w, RandomStream& random) const;
    std::size_t stratum_at(double z) const;
    double ceiling(std::size_t index) const { return index == 0 ? 0.0 : floor_[index - 1]; }

    Blend::Operator op_;
    std::vector<FacetStratum> strata_;
    std::vector<double> floor_;  // z of the lower boundary of each stratum
};

// The same height measured from the other side, where C is 1 - C.
double turned_over(double z);

}  // namespace lacquer::simulator
