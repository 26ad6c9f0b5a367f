// Where a rough surface sends light from one direction, order of scattering by order: by ray traced
// heightfields, and by Smith's theory in the same terms.
// Based on: d'Eon et al. 2023, Microfacet Theory for Non-Uniform Heightfields, section 4
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "heightfield/gaussian_field.h"
#include "simulator/microsurface.h"
#include "simulator/rgb_estimate.h"

namespace lacquer::heightfield {

// `energy` is the share of the light that arrives. `pixels` are f cos_theta_o per steradian,
// averaged over the pixels of a SlicePicture, row by row.
struct OrderLight {
    simulator::RgbEstimate energy;
    std::vector<simulator::RgbEstimate> pixels;
};

// Standard errors are those between repetitions: they hold the chance of the surface as well as
// that of the rays.
struct ScatteredLight {
    std::vector<OrderLight> orders;  // after 1, 2, ... facets, and last after any more
    simulator::RgbEstimate reflected, transmitted;
    double strays = 0.0;  // share of rays that were lost between facets
};

struct LightOptions {
    int orders = 3;                  // that are told apart, at least 1
    int picture_size = 64;           // pixels of either side
    std::uint64_t repetitions = 16;  // surfaces, or batches of walks; at least 2
    std::uint64_t rays = 1 << 16;    // per repetition
    std::uint64_t seed = 1;
    // Called now and then with the rays done since the last call, by one thread at a time.
    std::function<void(std::uint64_t)> on_rays{};
};

// Light from each direction of `wi` (unit, above the surface) on Gaussian heightfields, one random
// surface per repetition. See Heightfield for the strata.
std::vector<ScatteredLight> heightfield_light(std::span<const simulator::FacetStratum> strata,
                                              std::span<const simulator::Vec3> wi,
                                              const FieldGrid& grid, const LightOptions& options);

// The same light on Smith's surface.
std::vector<ScatteredLight> smith_light(const simulator::SurfaceWalk& surface,
                                        std::span<const simulator::Vec3> wi,
                                        const LightOptions& options);

}  // namespace lacquer::heightfield
