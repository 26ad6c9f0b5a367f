// Facets of a stretched heightfield: whole, each in one stratum, of the strata's own roughness.
#include "heightfield/facet_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "heightfield/heightfield.h"
#include "heightfield/surfaces.h"
#include "simulator/estimator.h"
#include "support/normal.h"

namespace lacquer::heightfield {
namespace {

using simulator::FacetStratum;

constexpr double kSignificance = 0.001;
constexpr FieldGrid kGrid{96, 6.0};

// Twice the area of a triangle times its normal.
glm::dvec3 area_vector(const FacetMesh& mesh, std::size_t triangle) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    return glm::cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]);
}

// Share of the horizontal area of each stratum, and its mean squared slopes.
struct StratumShape {
    double area = 0.0, slope_x2 = 0.0, slope_y2 = 0.0;
};

std::vector<StratumShape> shapes(const FacetMesh& mesh, std::size_t strata) {
    std::vector<StratumShape> result(strata);
    double whole = 0.0;
    for (std::size_t n = 0; n < mesh.triangles.size(); ++n) {
        const Facet& facet = mesh.facets[n];
        const double area = area_vector(mesh, n).z;
        whole += area;
        StratumShape& shape = result[facet.stratum];
        shape.area += area;
        shape.slope_x2 += area * std::pow(facet.normal.x / facet.normal.z, 2);
        shape.slope_y2 += area * std::pow(facet.normal.y / facet.normal.z, 2);
    }
    for (StratumShape& shape : result) {
        shape.slope_x2 /= shape.area;
        shape.slope_y2 /= shape.area;
        shape.area /= whole;
    }
    return result;
}

std::vector<FacetStratum> three_strata() {
    return {{0.25, test::beckmann(0.2, 0.4), test::kMirror},
            {0.5, test::beckmann(0.05, 0.1), test::kMirror},
            {0.25, test::beckmann(0.45, 0.9), test::kMirror}};
}

TEST(FacetMesh, NormalsAreThoseOfTheTriangles) {
    const Heightfield surface{three_strata(), kGrid, 1, 0};
    const FacetMesh& mesh = surface.mesh();
    for (std::size_t n = 0; n < mesh.triangles.size(); ++n) {
        const glm::dvec3 area = area_vector(mesh, n);
        EXPECT_GE(area.z, 0.0);
        // Slivers of cut triangles have no normal of their own.
        if (area.z < 1e-6) continue;
        EXPECT_NEAR(glm::distance(glm::normalize(area), mesh.facets[n].normal), 0.0, 1e-6) << n;
    }
}

TEST(FacetMesh, CutTrianglesFillThePlane) {
    const Heightfield surface{three_strata(), kGrid, 2, 0};
    const FacetMesh& mesh = surface.mesh();
    double area = 0.0;
    for (std::size_t n = 0; n < mesh.triangles.size(); ++n) area += 0.5 * area_vector(mesh, n).z;
    const double with_margin = std::pow(kGrid.cells + 2, 2);
    EXPECT_NEAR(area, with_margin * mesh.tile.cell_width * mesh.tile.cell_depth, 1e-6);
    EXPECT_GT(mesh.triangles.size(), std::size_t(2.0 * with_margin));  // some were cut
}

// Slopes of a stratum depend on its heights not at all (Gaussian heights and slopes at one place
// are independent), but for facets are differences of heights: a facet of the topmost stratum lies
// high with all its corners, which makes it flatter by less than 1 / cells_per_length^2.
TEST(FacetMesh, StrataHaveTheirShareOfTheAreaAndTheirRoughness) {
    constexpr int kSurfaces = 24;
    const std::vector<FacetStratum> strata = three_strata();
    std::vector<simulator::Moments> area(3), x2(3), y2(3);
    for (int surface = 0; surface < kSurfaces; ++surface) {
        const Heightfield field{strata, kGrid, 3, static_cast<std::uint64_t>(surface)};
        const std::vector<StratumShape> found = shapes(field.mesh(), strata.size());
        for (std::size_t n = 0; n < strata.size(); ++n) {
            area[n].add(found[n].area);
            x2[n].add(found[n].slope_x2);
            y2[n].add(found[n].slope_y2);
        }
    }
    const double z = lacquer::test::two_sided_z(kSignificance);
    const double coarseness = 1.0 / (kGrid.cells_per_length * kGrid.cells_per_length);
    for (std::size_t n = 0; n < strata.size(); ++n) {
        const auto& [weight, facets, material] = strata[n];
        EXPECT_NEAR(area[n].mean(kSurfaces), weight,
                    z * area[n].standard_error(kSurfaces) + coarseness * weight);
        const double variance_x = facets.alpha_x * facets.alpha_x / 2.0;
        const double variance_y = facets.alpha_y * facets.alpha_y / 2.0;
        EXPECT_NEAR(x2[n].mean(kSurfaces), variance_x,
                    z * x2[n].standard_error(kSurfaces) + coarseness * variance_x)
            << n;
        EXPECT_NEAR(y2[n].mean(kSurfaces), variance_y,
                    z * y2[n].standard_error(kSurfaces) + coarseness * variance_y)
            << n;
    }
}

TEST(FacetMesh, AStratumOfAlphaZeroIsAPlateau) {
    const Heightfield surface{test::two_strata(0.0, 0.5), kGrid, 4, 0};
    const FacetMesh& mesh = surface.mesh();
    for (std::size_t n = 0; n < mesh.facets.size(); ++n) {
        if (mesh.facets[n].stratum != 0) continue;
        EXPECT_EQ(mesh.facets[n].normal, glm::dvec3(0, 0, 1));
        for (const std::uint32_t corner : mesh.triangles[n])
            EXPECT_EQ(mesh.vertices[corner].z, mesh.highest);
    }
}

}  // namespace
}  // namespace lacquer::heightfield
