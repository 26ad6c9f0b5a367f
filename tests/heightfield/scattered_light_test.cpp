// Light by order of scattering: conserved, reproducible, and where it should go.
#include "heightfield/scattered_light.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <numbers>

#include "heightfield/surfaces.h"
#include "simulator/slice_picture.h"
#include "support/normal.h"

namespace lacquer::heightfield {
namespace {

using simulator::FacetStratum;
using simulator::Vec3;

constexpr FieldGrid kGrid{128, 8.0};

LightOptions few_rays() {
    LightOptions options;
    options.repetitions = 4;
    options.rays = 1 << 12;
    options.picture_size = 16;
    return options;
}

const std::vector<Vec3> kDirections{test::direction_at(0.2), test::direction_at(0.75),
                                    test::direction_at(1.5)};

double energy_of_orders(const ScatteredLight& light) {
    double sum = 0.0;
    for (const OrderLight& order : light.orders) sum += order.energy.mean[0];
    return sum;
}

// Between facets fewer rays are lost than this.
constexpr double kMostStrays = 1e-5;

TEST(ScatteredLight, MirrorsReturnAllLight) {
    for (const std::vector<FacetStratum>& strata :
         {test::uniform(1.0), test::two_strata(0.91, 0.364), test::two_strata(0.0, 0.8)})
        for (const ScatteredLight& light :
             heightfield_light(strata, kDirections, kGrid, few_rays())) {
            EXPECT_LE(light.strays, kMostStrays);
            EXPECT_NEAR(energy_of_orders(light) + light.strays, 1.0, 1e-9);
            EXPECT_NEAR(light.reflected.mean[1] + light.strays, 1.0, 1e-9);
            EXPECT_EQ(light.transmitted.mean[0], 0.0);
        }
}

TEST(ScatteredLight, WhiteDiffuseFacetsReturnAllLight) {
    const std::vector<FacetStratum> strata =
        test::uniform(0.8, simulator::DiffuseFacet{{1.0, 1.0, 1.0}});
    for (const ScatteredLight& light : heightfield_light(strata, kDirections, kGrid, few_rays()))
        EXPECT_NEAR(light.reflected.mean[0] + light.strays, 1.0, 1e-9);
}

TEST(ScatteredLight, DielectricFacetsReflectOrTransmitAllLight) {
    const std::vector<FacetStratum> strata = test::uniform(0.6, simulator::DielectricFacet{1.5});
    for (const ScatteredLight& light : heightfield_light(strata, kDirections, kGrid, few_rays())) {
        EXPECT_NEAR(light.reflected.mean[0] + light.transmitted.mean[0] + light.strays, 1.0, 1e-9);
        EXPECT_GT(light.transmitted.mean[0], 0.1);
    }
}

// Order 1 is red from the upper stratum and blue from the lower.
TEST(ScatteredLight, StrataHaveTheirOwnMaterials) {
    const std::vector<FacetStratum> strata{
        {0.5, test::beckmann(0.5), simulator::DiffuseFacet{{0.8, 0.0, 0.0}}},
        {0.5, test::beckmann(0.5), simulator::DiffuseFacet{{0.0, 0.0, 0.8}}}};
    const auto light = heightfield_light(strata, kDirections, kGrid, few_rays());
    // Along the normal each stratum is seen by its area, towards the horizon mostly the top.
    EXPECT_NEAR(light[0].orders[0].energy.mean[0], light[0].orders[0].energy.mean[2], 0.15);
    EXPECT_GT(light[2].orders[0].energy.mean[0], 5.0 * light[2].orders[0].energy.mean[2]);
    for (const ScatteredLight& one : light) EXPECT_EQ(one.orders[0].energy.mean[1], 0.0);
}

TEST(ScatteredLight, FlatDiffuseFacetsAreLambertian) {
    LightOptions options = few_rays();
    options.rays = 1 << 15;
    const auto light = heightfield_light(
        test::uniform(0.0, simulator::DiffuseFacet{{0.5, 0.5, 0.5}}), kDirections, kGrid, options);
    const simulator::SlicePicture picture{options.picture_size};
    const double rays = static_cast<double>(options.repetitions * options.rays);
    for (const ScatteredLight& one : light) {
        EXPECT_NEAR(one.orders[0].energy.mean[0], 0.5, 1e-9);
        for (std::size_t n = 0; n < picture.pixel_count(); ++n) {
            // Whole pixels only: the corner that is farthest from the normal is on the disk.
            double least = 1.0;
            for (const double x : {0.0, 1.0})
                for (const double y : {0.0, 1.0})
                    least =
                        std::min(least, simulator::SlicePicture::cosine(picture.position(n, x, y)));
            if (least < 0.0) continue;
            const double share = picture.projected_solid_angle(n) / std::numbers::pi;
            const double found = one.orders[0].pixels[n].mean[0] * picture.solid_angle() / 0.5;
            constexpr double kSignificance = 1e-5;  // of each of 3 * 256 pixels
            EXPECT_NEAR(found, share,
                        lacquer::test::two_sided_z(kSignificance) * std::sqrt(share / rays))
                << n;
        }
    }
}

TEST(ScatteredLight, PicturesHoldTheEnergyOfTheirOrder) {
    const auto light =
        heightfield_light(test::two_strata(0.91, 0.364), kDirections, kGrid, few_rays());
    const simulator::SlicePicture picture{few_rays().picture_size};
    for (const ScatteredLight& one : light)
        for (const OrderLight& order : one.orders) {
            double sum = 0.0;
            for (const simulator::RgbEstimate& pixel : order.pixels)
                sum += pixel.mean[0] * picture.solid_angle();
            EXPECT_NEAR(sum, order.energy.mean[0], 1e-9);
        }
}

TEST(ScatteredLight, TheNumberOfThreadsChangesNothing) {
    const auto by = [](std::size_t threads) {
        const tbb::global_control limit{tbb::global_control::max_allowed_parallelism, threads};
        return heightfield_light(test::two_strata(0.91, 0.364), kDirections, kGrid, few_rays());
    };
    const auto one = by(1), four = by(4);
    for (std::size_t n = 0; n < one.size(); ++n)
        for (std::size_t order = 0; order < one[n].orders.size(); ++order) {
            EXPECT_EQ(one[n].orders[order].energy.mean, four[n].orders[order].energy.mean);
            for (std::size_t pixel = 0; pixel < one[n].orders[order].pixels.size(); ++pixel)
                EXPECT_EQ(one[n].orders[order].pixels[pixel].mean,
                          four[n].orders[order].pixels[pixel].mean);
        }
}

TEST(ScatteredLight, SeedsGiveOtherSurfaces) {
    LightOptions other = few_rays();
    other.seed = 2;
    const auto strata = test::uniform(0.9);
    EXPECT_NE(heightfield_light(strata, kDirections, kGrid, few_rays())[1].orders[0].energy.mean,
              heightfield_light(strata, kDirections, kGrid, other)[1].orders[0].energy.mean);
}

}  // namespace
}  // namespace lacquer::heightfield
