// A stretched heightfield as triangles, one tile of a periodic surface.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "heightfield/stretch.h"

namespace lacquer::heightfield {

// The tile: heights at the corners of cells x cells rectangles, x = column * cell_width,
// y = row * cell_depth.
struct Tile {
    int cells = 0;
    double cell_width = 1.0, cell_depth = 1.0;

    double width() const { return cells * cell_width; }
    double depth() const { return cells * cell_depth; }
};

struct Facet {
    glm::dvec3 normal{};  // unit, upwards
    std::uint32_t stratum = 0;
};

// Each cell is two triangles, its diagonal from its corner of larger x to that of larger y. A
// triangle that a boundary between strata crosses is cut along it, so that every facet lies in one
// stratum. The mesh goes on for one cell beyond each edge of the tile.
struct FacetMesh {
    Tile tile;
    std::vector<glm::dvec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;  // counterclockwise from above
    std::vector<Facet> facets;                            // of each triangle
    double lowest = 0.0, highest = 0.0;
};

// `heights` before stretching, row by row along x.
FacetMesh make_mesh(const Tile& tile, std::span<const double> heights, const Stretch& stretch);

}  // namespace lacquer::heightfield
