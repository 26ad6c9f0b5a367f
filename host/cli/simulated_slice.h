// `lacquer slice --method simulate`: the picture by walks of light.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "cli/simulate_options.h"
#include "image/exr.h"
#include "image/image.h"
#include "lacquer/material.h"

namespace lacquer {

// Larger pictures would need more memory for their sums than they are worth.
inline constexpr int kMaxSimulatedSize = 1024;

struct SimulatedSlice {
    Image image;  // f per pixel, alpha 1 where there is a direction
    Metadata metadata;
};

// Throws UsageError for a size over kMaxSimulatedSize. The metadata says how the values were
// estimated and how exact they are.
SimulatedSlice simulate_slice(const Material& material, const glm::dvec3& wo, int size,
                              std::uint64_t samples, const SimulateOptions& options);

}  // namespace lacquer
