#include "heightfield/heightfield.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "heightfield/rough_surface.h"
#include "simulator/roulette.h"

namespace lacquer::heightfield {

namespace {

using simulator::FacetMaterial;
using simulator::FacetStratum;
using simulator::RandomStream;
using simulator::Vec3;

// A ray that passes more copies of the tile than this without meeting a facet or leaving runs along
// a periodic channel.
constexpr int kMaxTiles = 10'000;

// Light along the plane of the surface arrives at this cosine.
constexpr double kMinArrivalCosine = 1e-6;

// How far outside the surface rays start, so that they meet facets that lie flat at its end.
constexpr double kClearance = 1.0;

// Rays pass to the next tile this share of a cell beyond the edge, where the mesh still goes on.
constexpr double kOverlap = 0.5;

// Cells are 1 wide, and as deep as makes the alphas those of the strata.
RayScene make_scene(std::span<const FacetStratum> strata, const FieldGrid& grid,
                    RandomStream random) {
    require_stretchable(strata);
    const std::vector<double> heights = gaussian_field(grid, random);
    const double slope_per_height = std::sqrt(2.0 * step_variance(grid));
    std::vector<StretchedStratum> stretched;
    Tile tile{grid.cells, 1.0, 1.0};
    for (const FacetStratum& stratum : strata) {
        const simulator::Facets& facets = stratum.facets;
        stretched.push_back({stratum.weight, facets.alpha_x / slope_per_height});
        if (facets.alpha_x > 0.0) tile.cell_depth = facets.alpha_x / facets.alpha_y;
    }
    return RayScene{make_mesh(tile, heights, Stretch{stretched, heights})};
}

FacetMaterial turned_over(FacetMaterial material) {
    if (auto* dielectric = std::get_if<simulator::DielectricFacet>(&material))
        dielectric->eta = 1.0 / dielectric->eta;
    return material;
}

// The distance to where a ray leaves [-overlap, size + overlap].
double distance_to_edge(double position, double direction, double size, double overlap) {
    if (direction == 0.0) return HUGE_VAL;
    return ((direction > 0.0 ? size + overlap : -overlap) - position) / direction;
}

double wrapped(double position, double size) {
    return position - size * std::floor(position / size);
}

}  // namespace

struct Heightfield::Ray {
    Vec3 position, direction;
    bool below = false;
    std::uint32_t triangle = 0;  // that it stands on, after meeting a facet
};

Heightfield::Heightfield(std::span<const FacetStratum> strata, const FieldGrid& grid,
                         std::uint64_t seed, std::uint64_t number)
    : scene_{make_scene(strata, grid, RandomStream{seed, number})} {
    for (const FacetStratum& stratum : strata) {
        from_above_.push_back(stratum.material);
        from_below_.push_back(turned_over(stratum.material));
    }
}

Vec3 Heightfield::start(const Vec3& direction, RandomStream& random) const {
    const double x = random.uniform() * mesh().tile.width();
    const double y = random.uniform() * mesh().tile.depth();
    return {x, y, direction.z > 0.0 ? mesh().lowest - kClearance : mesh().highest + kClearance};
}

Heightfield::End Heightfield::fly(Ray& ray) const {
    const Tile& tile = mesh().tile;
    const Vec3& w = ray.direction;
    const bool leaving = ray.below ? w.z < 0.0 : w.z > 0.0;
    for (int tiles = 0; tiles < kMaxTiles; ++tiles) {
        Vec3& p = ray.position;
        p.x = wrapped(p.x, tile.width());
        p.y = wrapped(p.y, tile.depth());
        // Beyond `until` is nothing of the surface, or all of it.
        const double end = w.z > 0.0 ? mesh().highest : mesh().lowest;
        const double until = w.z == 0.0 ? HUGE_VAL : (end - p.z) / w.z;
        const double edge =
            std::min(distance_to_edge(p.x, w.x, tile.width(), kOverlap * tile.cell_width),
                     distance_to_edge(p.y, w.y, tile.depth(), kOverlap * tile.cell_depth));
        // A margin for facets that lie flat at the end.
        const double distance = std::min(edge, until + kOverlap);
        if (const auto hit = scene_.first_hit(p, w, distance, ray.below)) {
            p = hit->point;
            ray.triangle = hit->triangle;
            return End::facet;
        }
        if (until <= edge) return leaving ? End::away : End::stray;
        p += edge * w;
    }
    return End::stray;
}

bool Heightfield::turn(Ray& ray, Vec3& weight, RandomStream& random) const {
    const Facet& facet = mesh().facets[ray.triangle];
    const FacetMaterial& material = (ray.below ? from_below_ : from_above_)[facet.stratum];
    const Vec3 normal = ray.below ? -facet.normal : facet.normal;
    const simulator::FacetEvent event =
        simulator::meet_facet(material, ray.direction, normal, random);
    ray.direction = event.direction;
    ray.below = ray.below != event.refracted;
    weight *= event.weight;
    return simulator::survives(weight, random);
}

Trip Heightfield::cross(const Vec3& direction, RandomStream& random, int max_order) const {
    Ray ray;
    ray.direction = direction;
    if (std::abs(direction.z) < kMinArrivalCosine)
        ray.direction.z = direction.z > 0.0 ? kMinArrivalCosine : -kMinArrivalCosine;
    ray.position = start(direction, random);
    ray.below = direction.z > 0.0;
    Trip trip;
    for (End end; (end = fly(ray)) != End::away;) {
        trip.stray = end == End::stray;
        trip.lost = trip.stray || trip.order == max_order;
        if (trip.lost) break;
        ++trip.order;
        trip.lost = !turn(ray, trip.weight, random);
        if (trip.lost) break;
    }
    trip.below = ray.below;
    trip.direction = ray.direction;
    return trip;
}

std::optional<RayHit> Heightfield::look(const Vec3& origin, const Vec3& direction) const {
    Ray ray{origin, direction, false, 0};
    if (fly(ray) != End::facet) return std::nullopt;
    return RayHit{ray.triangle, ray.position};
}

}  // namespace lacquer::heightfield
