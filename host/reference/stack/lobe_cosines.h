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
    std::size_t count = 0;

    void add(double cosine, double weight);

    // Mean of the cosines.
    double mean() const;
};

// The light that visible facets mirror about the lobe's mean, in proportion to what the surface
// does not shadow; what it shadows is scattered again, and spread as diffuse light.
LobeCosines lobe_cosines(const LobeShape& shape);

// Light from everywhere alike.
LobeCosines diffuse_cosines();

}  // namespace lacquer::reference
