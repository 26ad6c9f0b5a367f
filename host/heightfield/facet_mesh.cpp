#include "heightfield/facet_mesh.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

namespace lacquer::heightfield {

namespace {

// A corner of the mesh before stretching.
struct Corner {
    double x = 0.0, y = 0.0, height = 0.0;
    std::uint32_t vertex = 0;  // where there is one of this place already
};

constexpr std::uint32_t kNoVertex = std::numeric_limits<std::uint32_t>::max();

class Builder {
 public:
    Builder(const Tile& tile, std::span<const double> heights, const Stretch& stretch)
        : heights_{heights}, stretch_{stretch}, side_{tile.cells + 3} {
        mesh_.tile = tile;
    }

    FacetMesh build() {
        add_grid_vertices();
        for (int row = -1; row <= mesh_.tile.cells; ++row)
            for (int column = -1; column <= mesh_.tile.cells; ++column) add_cell(column, row);
        const auto [low, high] = std::ranges::minmax_element(
            mesh_.vertices, {}, [](const glm::dvec3& vertex) { return vertex.z; });
        mesh_.lowest = low->z;
        mesh_.highest = high->z;
        return std::move(mesh_);
    }

 private:
    Corner corner(int column, int row) const {
        const int cells = mesh_.tile.cells;
        const auto wrapped = [cells](int n) {
            return static_cast<std::size_t>((n + cells) % cells);
        };
        return {column * mesh_.tile.cell_width, row * mesh_.tile.cell_depth,
                heights_[wrapped(row) * static_cast<std::size_t>(cells) + wrapped(column)],
                static_cast<std::uint32_t>((row + 1) * side_ + column + 1)};
    }

    void add_grid_vertices() {
        for (int row = -1; row <= mesh_.tile.cells + 1; ++row)
            for (int column = -1; column <= mesh_.tile.cells + 1; ++column)
                add_vertex(corner(column, row));
    }

    std::uint32_t add_vertex(const Corner& corner) {
        mesh_.vertices.emplace_back(corner.x, corner.y, stretch_(corner.height));
        return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
    }

    void add_cell(int column, int row) {
        const Corner near_left = corner(column, row), near_right = corner(column + 1, row);
        const Corner far_left = corner(column, row + 1), far_right = corner(column + 1, row + 1);
        const double width = mesh_.tile.cell_width, depth = mesh_.tile.cell_depth;
        add_triangle({near_left, near_right, far_left},
                     {(near_right.height - near_left.height) / width,
                      (far_left.height - near_left.height) / depth});
        add_triangle({far_right, far_left, near_right},
                     {(far_right.height - far_left.height) / width,
                      (far_right.height - near_right.height) / depth});
    }

    struct Slope {
        double x, y;  // before stretching
    };

    void add_triangle(const std::array<Corner, 3>& corners, const Slope& slope) {
        const auto [low, high] = std::ranges::minmax(corners, {}, &Corner::height);
        const std::size_t top = stretch_.stratum(high.height),
                          bottom = stretch_.stratum(low.height);
        if (top == bottom) return add_facets(corners, slope, top);
        for (std::size_t stratum = top; stratum <= bottom; ++stratum) {
            std::vector<Corner> polygon{corners.begin(), corners.end()};
            const auto boundaries = stretch_.boundaries();
            if (stratum > top) polygon = cut(polygon, boundaries[stratum - 1], false);
            if (stratum < bottom) polygon = cut(polygon, boundaries[stratum], true);
            for (Corner& corner : polygon)
                if (corner.vertex == kNoVertex) corner.vertex = add_vertex(corner);
            add_facets(polygon, slope, stratum);
        }
    }

    // The part of a convex polygon above or below a height that none of its corners has, unless it
    // was cut there.
    static std::vector<Corner> cut(const std::vector<Corner>& polygon, double height, bool above) {
        std::vector<Corner> part;
        for (std::size_t n = 0; n < polygon.size(); ++n) {
            const Corner& from = polygon[n];
            const Corner& to = polygon[(n + 1) % polygon.size()];
            if (from.height == height || above == (from.height > height)) part.push_back(from);
            if ((from.height < height && to.height > height) ||
                (from.height > height && to.height < height))
                part.push_back(between(from, to, height));
        }
        return part;
    }

    // The same numbers whichever way the edge is passed: two triangles share it.
    static Corner between(const Corner& a, const Corner& b, double height) {
        const Corner& low = a.height < b.height ? a : b;
        const Corner& high = a.height < b.height ? b : a;
        const double t = (height - low.height) / (high.height - low.height);
        return {low.x + t * (high.x - low.x), low.y + t * (high.y - low.y), height, kNoVertex};
    }

    void add_facets(std::span<const Corner> polygon, const Slope& slope, std::size_t stratum) {
        const double factor = stretch_.factor(stratum);
        const Facet facet{glm::normalize(glm::dvec3{-factor * slope.x, -factor * slope.y, 1.0}),
                          static_cast<std::uint32_t>(stratum)};
        for (std::size_t n = 2; n < polygon.size(); ++n) {
            mesh_.triangles.push_back(
                {polygon[0].vertex, polygon[n - 1].vertex, polygon[n].vertex});
            mesh_.facets.push_back(facet);
        }
    }

    FacetMesh mesh_;
    std::span<const double> heights_;
    const Stretch& stretch_;
    int side_;  // vertices along a side
};

}  // namespace

FacetMesh make_mesh(const Tile& tile, std::span<const double> heights, const Stretch& stretch) {
    return Builder{tile, heights, stretch}.build();
}

}  // namespace lacquer::heightfield
