// The value of a rough surface's BSDF at one pair of directions, without waiting for a walk to end
// there.
// Based on: Heitz et al. 2016, Multiple-Scattering Microfacet BSDFs with the Smith Model
#pragma once

#include "simulator/microsurface.h"

namespace lacquer::simulator {

// Whether facets of the surface scatter to a density: none of them lie flat.
bool has_density(const SurfaceWalk& surface);

// One walk of light that arrives along wo: an unbiased estimate of the density, per solid angle,
// with which it leaves along wi, all orders up to `max_order` together. For wi above the surface
// that is f(wi, wo) |cos_theta_i|. At every facet met, the facet's closed form towards wi times the
// probability of leaving without meeting another. `wi`, `wo` unit, to either side; has_density().
Vec3 next_event_density(const SurfaceWalk& surface, const Vec3& wi, const Vec3& wo,
                        RandomStream& random, int max_order = kAllOrders);

}  // namespace lacquer::simulator
