#include "shading/several_facets_rows.h"

#include <algorithm>

#include "shading/shader_double.h"
// After the shader source:
#include "shading/microsurface_material.h"

namespace lacquer {

namespace {

using SideRows = std::array<glm::vec4, kSeveralFacetsSideRows>;

SideRows rows_of(const shader::LqSeveralFacetsSide& side) {
    const auto colour = [](const shader::vec3& rgb, double w) { return glm::vec4{rgb, w}; };
    SideRows rows{};
    auto row = rows.begin();
    for (const shader::LqAlbedoFit& fit : {side.in_xz, side.in_yz})
        for (const shader::vec3& coefficient : {fit.of_zero, fit.of_one, fit.of_two, fit.of_three,
                                                fit.of_four, fit.of_five, fit.of_six})
            *row++ = colour(coefficient, 0.0);
    *row++ = colour(side.average_reflected, side.average_through);
    *row = {side.through_at_grazing, side.through_slope, 0.0, 0.0};
    return rows;
}

}  // namespace

std::array<glm::vec4, kSeveralFacetsRows> several_facets_rows(
    const MicrosurfaceParameters& parameters) {
    const shader::LqSeveralFacets several = to_several_facets(parameters);
    std::array<glm::vec4, kSeveralFacetsRows> rows{};
    rows[0] = {several.turning.is_rougher_along_x ? 1.0 : 0.0, several.turning.alpha_squared_ratio,
               several.turning.beckmann_share, 0.0};
    const SideRows above = rows_of(several.above), below = rows_of(several.below);
    std::ranges::copy(below, std::ranges::copy(above, rows.begin() + 1).out);
    return rows;
}

}  // namespace lacquer
