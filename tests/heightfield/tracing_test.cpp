// Rays on heightfields: where they hit, and that none of their light is lost.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "heightfield/heightfield.h"
#include "heightfield/surfaces.h"

namespace lacquer::heightfield {
namespace {

using simulator::FacetStratum;
using simulator::RandomStream;
using simulator::Vec3;

constexpr FieldGrid kTiny{32, 4.0};

// The surface as a function of place, from its heights alone: each cell's two triangles, stretched.
class Relief {
 public:
    Relief(const std::vector<FacetStratum>& strata, std::uint64_t seed)
        : heights_{field(seed)}, stretch_{scaled(strata), heights_} {
        depth_ = strata.front().facets.alpha_x / strata.front().facets.alpha_y;
    }

    double height(double x, double y) const {
        const double column = x - std::floor(x), row = y / depth_ - std::floor(y / depth_);
        const int i = int(std::floor(x)), j = int(std::floor(y / depth_));
        const double right = at(i + 1, j), far = at(i, j + 1);
        const double raw = column + row < 1.0
                               ? at(i, j) + column * (right - at(i, j)) + row * (far - at(i, j))
                               : at(i + 1, j + 1) + (1.0 - column) * (far - at(i + 1, j + 1)) +
                                     (1.0 - row) * (right - at(i + 1, j + 1));
        return stretch_(raw);
    }

    // The distance at which a ray from above first passes below the surface: marching, and halving
    // the step that does.
    double march(const Vec3& origin, const Vec3& direction, double most) const {
        constexpr double kStep = 1.0 / 256;
        const auto above = [&](double t) {
            const Vec3 p = origin + t * direction;
            return p.z > height(p.x, p.y);
        };
        double t = kStep;
        while (above(t)) {
            if (t > most) return HUGE_VAL;
            t += kStep;
        }
        double low = t - kStep, high = t;
        for (int n = 0; n < 40; ++n) {
            const double middle = 0.5 * (low + high);
            (above(middle) ? low : high) = middle;
        }
        return high;
    }

 private:
    static std::vector<double> field(std::uint64_t seed) {
        RandomStream random{seed, 0};
        return gaussian_field(kTiny, random);
    }

    static std::vector<StretchedStratum> scaled(const std::vector<FacetStratum>& strata) {
        std::vector<StretchedStratum> result;
        for (const FacetStratum& stratum : strata)
            result.push_back(
                {stratum.weight, stratum.facets.alpha_x / std::sqrt(2.0 * step_variance(kTiny))});
        return result;
    }

    double at(int column, int row) const {
        const auto wrap = [](int n) { return (n % kTiny.cells + kTiny.cells) % kTiny.cells; };
        return heights_[static_cast<std::size_t>(wrap(row) * kTiny.cells + wrap(column))];
    }

    std::vector<double> heights_;
    Stretch stretch_;
    double depth_ = 1.0;
};

// Marching misses what a ray grazes for less than a step; both round.
TEST(Tracing, RaysMeetTheFacetThatMarchingFinds) {
    constexpr int kRays = 400;
    constexpr int kGrazed = kRays / 100;
    for (const std::vector<FacetStratum>& strata :
         {test::uniform(0.6), test::two_strata(0.9, 0.3),
          std::vector<FacetStratum>{{0.3, test::beckmann(0.2, 0.4), test::kMirror},
                                    {0.7, test::beckmann(0.4, 0.8), test::kMirror}}}) {
        const Heightfield surface{strata, kTiny, 7, 0};
        const Relief relief{strata, 7};
        RandomStream random{8, 0};
        int missed = 0;
        for (int n = 0; n < kRays; ++n) {
            const Vec3 up = simulator::sample_cosine(random);
            const Vec3 direction = -glm::normalize(up + Vec3{0.0, 0.0, 0.05});
            const Vec3 origin{100.0 * random.uniform(), 100.0 * random.uniform(),
                              surface.mesh().highest + 0.5};
            const auto hit = surface.look(origin, direction);
            ASSERT_TRUE(hit);
            const double expected = relief.march(origin, direction, 1e3);
            const double found = (hit->point.z - origin.z) / direction.z;
            missed += std::abs(found - expected) > 1e-3 ? 1 : 0;
        }
        EXPECT_LE(missed, kGrazed);
    }
}

TEST(Tracing, RaysThatLeaveAFacetGoWhereMarchingGoes) {
    constexpr int kRays = 400;
    constexpr int kGrazed = kRays / 100;
    const std::vector<FacetStratum> strata = test::two_strata(0.9, 0.5);
    const Heightfield surface{strata, kTiny, 9, 0};
    const Relief relief{strata, 9};
    RandomStream random{10, 0};
    int missed = 0, met = 0;
    for (int n = 0; n < kRays; ++n) {
        const Vec3 origin{kTiny.cells * random.uniform(), kTiny.cells * random.uniform(),
                          surface.mesh().highest + 0.5};
        const auto first = surface.look(origin, glm::normalize(Vec3{0.9, 0.1, -0.5}));
        ASSERT_TRUE(first);
        const Vec3 normal = surface.mesh().facets[first->triangle].normal;
        const Vec3 away = glm::normalize(normal + 0.999 * simulator::sample_sphere(random));
        const double until = (surface.mesh().highest - first->point.z) / std::max(away.z, 1e-3);
        // Marching starts clear of the facet that the ray leaves.
        const Vec3 start = first->point + 1e-4 * away;
        const double expected = relief.march(start, away, std::min(until, 300.0));
        if (away.z <= 1e-3 && expected == HUGE_VAL) continue;
        const auto second = surface.look(first->point, away);
        if (second) ++met;
        if (second.has_value() != std::isfinite(expected)) {
            ++missed;
            continue;
        }
        if (!second) continue;
        const double along =
            std::abs(away.z) > 1e-2 ? (second->point.z - start.z) / away.z : expected;
        missed += std::abs(along - expected) > 1e-2 ? 1 : 0;
    }
    EXPECT_LE(missed, kGrazed);
    EXPECT_GT(met, kRays / 20);
}

TEST(Tracing, AFlatSurfaceIsAMirror) {
    const Heightfield surface{test::uniform(0.0), kTiny, 1, 0};
    RandomStream random{1, 1};
    for (const double theta : {0.0, 0.3, 1.0, 1.5, 1.57}) {
        const Vec3 wi = test::direction_at(theta);
        for (int ray = 0; ray < 100; ++ray) {
            const Trip trip = surface.cross(-wi, random);
            EXPECT_FALSE(trip.lost);
            EXPECT_EQ(trip.order, 1);
            EXPECT_NEAR(glm::distance(trip.direction, Vec3(-wi.x, -wi.y, wi.z)), 0.0, 1e-12);
        }
    }
}

TEST(Tracing, RaysFromBelowPassDielectricFacetsToo) {
    const Heightfield surface{test::uniform(0.5, simulator::DielectricFacet{1.5}), kTiny, 1, 0};
    RandomStream random{1, 1};
    constexpr int kRays = 2000;
    int above = 0, below = 0;
    for (int ray = 0; ray < kRays; ++ray) {
        const Trip trip = surface.cross(glm::normalize(Vec3{0.2, 0.1, 1.0}), random);
        ASSERT_FALSE(trip.lost);
        EXPECT_EQ(trip.below, trip.direction.z < 0.0);
        ++(trip.below ? below : above);
    }
    // Near the normal nearly all of it leaves.
    EXPECT_GT(above, kRays / 2);
    EXPECT_GT(below, 0);
}

TEST(Tracing, LightBeyondTheLimitOfOrdersIsLost) {
    const Heightfield surface{test::uniform(0.9), kTiny, 1, 0};
    const Vec3 direction = -test::direction_at(0.75);
    constexpr std::uint64_t kRays = 2000;
    int lost = 0, of_higher_order = 0;
    for (std::uint64_t ray = 0; ray < kRays; ++ray) {
        RandomStream limited{1, ray}, unlimited{1, ray};
        const Trip first = surface.cross(direction, limited, 1);
        const Trip all = surface.cross(direction, unlimited);
        EXPECT_FALSE(first.stray);
        lost += first.lost ? 1 : 0;
        of_higher_order += all.order > 1 ? 1 : 0;
    }
    EXPECT_EQ(lost, of_higher_order);
    EXPECT_GT(lost, 0);
}

}  // namespace
}  // namespace lacquer::heightfield
