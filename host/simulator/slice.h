// The BSDF of a material over all light directions, for one viewer.
#pragma once

#include <cstdint>
#include <vector>

#include "simulator/rgb_estimate.h"
#include "simulator/stack.h"

namespace lacquer::simulator {

enum class SliceMethod {
    next_event,  // every walk estimates f at the centre of one pixel
    histogram,   // every walk ends in some pixel: f averaged over it, weighted by the cosine
};

struct SliceEstimate {
    SliceMethod method = SliceMethod::histogram;
    // f per pixel, row by row from the top; 0 outside the disk. A pixel with no walk yet is 0.
    std::vector<RgbEstimate> pixels;
    std::uint64_t samples = 0;  // walks made; fewer than asked when stopped
};

// Slice of `size` x `size` pixels for the viewer wo (unit, above the surface). The light's
// hemisphere fills the picture's unit disk by Lambert's azimuthal equal-area projection, x to the
// right, y up. Next-event estimates serve materials that are one rough surface; through several
// interfaces there is no closed form to make them of.
SliceEstimate estimate_slice(const StackWalk& stack, const Vec3& wo, int size,
                             const RunOptions& options);

}  // namespace lacquer::simulator
