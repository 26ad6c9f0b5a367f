// The directions of a lobe as a few cosines with weights, over which the coefficients of interfaces
// and media are averaged: taken at the mean direction alone they are wrong by as much as 0.15 where
// a wide lobe reaches beyond the critical angle or takes long ways through a dark medium.
#pragma once

#include <array>
#include <cstddef>

#include "reference/stack/lobe_shape.h"
#include "reference/stack/visible_facets.h"

namespace lacquer::reference {

struct LobeCosines {
    static constexpr std::size_t kDiffuse = 4;
    std::array<double, std::tuple_size_v<VisibleFacets> + kDiffuse> cosines;
    std::array<double, std::tuple_size_v<VisibleFacets> + kDiffuse> weights;  // 1 in all
    std::array<double, std::tuple_size_v<VisibleFacets> + kDiffuse> sines;    // along the mean's
    std::size_t count = 0;

    void add(double cosine, double sine, double weight);
};

// Moments of a part of a lobe's light, added up direction by direction.
class LobePart {
 public:
    void add(const LobeCosines& lobe, std::size_t n, double factor);

    double light() const { return light_; }
    double mean_cosine() const { return cosine_ / light_; }

    // Of the directions projected to the disk, both axes together.
    double spread() const;

 private:
    double light_ = 0.0, cosine_ = 0.0, sine_ = 0.0, square_ = 0.0;
};

// The light that visible facets mirror about the lobe's mean, in proportion to what the surface
// does not shadow; what it shadows is scattered again, and spread as diffuse light.
LobeCosines lobe_cosines(const LobeShape& shape);

// Light from everywhere alike.
LobeCosines diffuse_cosines();

}  // namespace lacquer::reference
