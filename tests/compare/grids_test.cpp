#include "compare/grids.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace lacquer {
namespace {

// Rounding three coordinates to float moves a unit vector's length by at most sqrt(3) halves of an
// ulp below 1.
constexpr double kLengthRounding = 1.1e-7;

double length(const glm::vec3& w) {
    return glm::length(glm::dvec3{w});
}

TEST(SliceGrid, HoldsUnitDirectionsAboveTheSurface) {
    const QueryGrid grid = slice_grid("slice", direction_at(60.0), 128);
    for (std::size_t i = 0; i < grid.query_count(); ++i) {
        const Query query = query_of(grid, i);
        ASSERT_NEAR(length(query.wi), 1.0, kLengthRounding);
        ASSERT_GT(query.wi.z, 0.0f);
    }
}

TEST(SliceGrid, CoversTheDiskOfThePicture) {
    const QueryGrid grid = slice_grid("slice", direction_at(0.0), 128);
    // Pixel centres in a circle of radius 64 pixels: its area, within its circumference.
    EXPECT_NEAR(double(grid.query_count()), std::numbers::pi * 64 * 64, 2 * std::numbers::pi * 64);
    EXPECT_EQ(grid.inputs.size(), grid.query_count());
}

TEST(SliceGrid, GivesEveryPixelTheSameSolidAngle) {
    // The mean of cos(theta) over the hemisphere is 1/2, of cos^2 is 1/3. Pixels at the edge are
    // in or out as a whole, which is good for three digits.
    const QueryGrid grid = slice_grid("slice", direction_at(0.0), 512);
    double sum = 0.0, sum_of_squares = 0.0;
    for (const glm::vec4& wi : grid.inputs) {
        sum += wi.z;
        sum_of_squares += double(wi.z) * wi.z;
    }
    EXPECT_NEAR(sum / double(grid.query_count()), 1.0 / 2.0, 1e-3);
    EXPECT_NEAR(sum_of_squares / double(grid.query_count()), 1.0 / 3.0, 1e-3);
}

TEST(SliceGrid, ReachesGrazingDirections) {
    const QueryGrid grid = slice_grid("slice", direction_at(0.0), kSliceSize);
    float lowest = 1.0f;
    for (const glm::vec4& wi : grid.inputs) lowest = std::min(lowest, wi.z);
    EXPECT_LT(lowest, std::cos(89.5 * std::numbers::pi / 180.0));
}

TEST(SliceGrid, PointsRightAndUpInThePicture) {
    const QueryGrid grid = slice_grid("slice", direction_at(0.0), 4);
    for (std::size_t i = 0; i < grid.query_count(); ++i) {
        const int x = static_cast<int>(grid.pixels[i] % 4),
                  y = static_cast<int>(grid.pixels[i] / 4);
        EXPECT_EQ(grid.inputs[i].x > 0.0f, x >= 2);
        EXPECT_EQ(grid.inputs[i].y > 0.0f, y < 2);
    }
}

TEST(SphereGrid, HoldsUnitDirectionsAndAViewerAbove) {
    const QueryGrid grid = sphere_grid("sphere", default_light(), 256);
    for (std::size_t i = 0; i < grid.query_count(); ++i) {
        const Query query = query_of(grid, i);
        ASSERT_NEAR(length(query.wi), 1.0, kLengthRounding);
        ASSERT_NEAR(length(query.wo), 1.0, kLengthRounding);
        ASSERT_GT(query.wo.z, 0.0f);
    }
}

TEST(SphereGrid, KeepsTheAngleBetweenLightAndViewer) {
    const QueryGrid grid = sphere_grid("sphere", default_light(), 64);
    for (std::size_t i = 0; i < grid.query_count(); ++i) {
        const Query query = query_of(grid, i);
        ASSERT_NEAR(glm::dot(glm::dvec3{query.wi}, glm::dvec3{query.wo}), default_light().z, 2e-7);
    }
}

TEST(SphereGrid, HasItsTangentsAlongTheParallels) {
    // A light from the pole has no eastward part anywhere.
    const QueryGrid grid = sphere_grid("sphere", {0.0, 1.0, 0.0}, 64);
    for (std::size_t i = 0; i < grid.query_count(); ++i)
        ASSERT_NEAR(query_of(grid, i).wi.x, 0.0, 1e-15);
}

TEST(SphereGrid, IsBrightestWhereItFacesTheLight) {
    const QueryGrid grid = sphere_grid("sphere", glm::normalize(glm::dvec3{1, 1, 1}), 65);
    std::size_t brightest = 0;
    for (std::size_t i = 0; i < grid.query_count(); ++i)
        if (query_of(grid, i).wi.z > query_of(grid, brightest).wi.z) brightest = i;
    // Position (1, 1) / sqrt(3) of the unit disk.
    EXPECT_NEAR(grid.pixels[brightest] % 65, 32.5 * (1 + std::sqrt(1.0 / 3.0)) - 0.5, 1.0);
    EXPECT_NEAR(grid.pixels[brightest] / 65, 32.5 * (1 - std::sqrt(1.0 / 3.0)) - 0.5, 1.0);
}

TEST(SphereUv, IsHalfAndHalfAtTheCentre) {
    const QueryGrid grid = sphere_grid("sphere", default_light(), 3);
    for (std::size_t i = 0; i < grid.query_count(); ++i) {
        if (grid.pixels[i] != 4) continue;
        EXPECT_DOUBLE_EQ(sphere_uv(grid, i).x, 0.5);
        EXPECT_DOUBLE_EQ(sphere_uv(grid, i).y, 0.5);
    }
}

TEST(SphereUv, GrowsEastAndUp) {
    const QueryGrid grid = sphere_grid("sphere", default_light(), 32);
    for (std::size_t i = 0; i < grid.query_count(); ++i) {
        const glm::dvec2 uv = sphere_uv(grid, i);
        ASSERT_EQ(uv.x > 0.5, grid.pixels[i] % 32 >= 16);
        ASSERT_EQ(uv.y > 0.5, grid.pixels[i] / 32 < 16);
    }
}

TEST(Paint, LeavesPixelsWithoutQueriesTransparent) {
    const QueryGrid grid = slice_grid("slice", direction_at(0.0), 8);
    const std::vector<glm::dvec4> rows(grid.query_count(), {1.0, 2.0, 3.0, 9.0});
    const Image image = paint(grid, rows);
    EXPECT_EQ(image.at(0, 0), glm::vec4(0.0f));
    EXPECT_EQ(image.at(4, 4), glm::vec4(1.0f, 2.0f, 3.0f, 1.0f));
}

TEST(DefaultSuite, ExecutesOverAMillionQueriesOnEightMaterials) {
    std::size_t queries = 0;
    for (const QueryGrid& grid : default_suite()) queries += grid.query_count();
    EXPECT_GE(8 * queries, 1'000'000u);
}

TEST(DefaultSuite, RunsFromTheNormalToGrazing) {
    const std::vector<QueryGrid> suite = default_suite();
    ASSERT_EQ(suite.size(), 9u);
    EXPECT_EQ(suite.front().parameters.wo[2], 1.0f);
    EXPECT_NEAR(suite[7].parameters.wo[2], std::cos(89.5 * std::numbers::pi / 180.0), 1e-9);
}

TEST(DirectionAt, IsExactAtTheHorizon) {
    EXPECT_EQ(direction_at(90.0).z, 0.0);
}

}  // namespace
}  // namespace lacquer
