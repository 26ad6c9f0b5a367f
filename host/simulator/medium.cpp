#include "simulator/medium.h"

#include <algorithm>
#include <cmath>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include "simulator/roulette.h"

namespace lacquer::simulator {

namespace {

// Cosine of a path along the plane of the slab: keeps its length finite.
constexpr double kMinPathCosine = 1e-12;

// Below this mean cosine the inverse of the phase function's distribution divides rounding errors
// by so little that isotropy is closer.
constexpr double kIsotropic = 1e-8;

Vec3 to_vec3(const Rgb& rgb) {
    return {rgb[0], rgb[1], rgb[2]};
}

double mean(const Vec3& v) {
    return (v.x + v.y + v.z) / 3.0;
}

// Length of the path from `height` above the lower plane to the plane that w points to.
double path_to_plane(const Slab& slab, const Vec3& w, double height) {
    const double vertical = w.z < 0.0 ? height : slab.thickness - height;
    return vertical / std::max(std::abs(w.z), kMinPathCosine);
}

// One walk serves three channels: the distance to the next event is drawn from the extinction of
// one of them at random, and the balance heuristic over all three keeps every weight bounded.
void scatter_through(const Slab& slab, Passage& passage, RandomStream& random) {
    const Vec3 sigma_t = slab.sigma_a + slab.sigma_s;
    Vec3& w = passage.direction;
    double height = w.z < 0.0 ? slab.thickness : 0.0;
    for (;;) {
        const double to_plane = path_to_plane(slab, w, height);
        const int channel = std::min(static_cast<int>(3.0 * random.uniform()), 2);
        const double distance = -std::log(random.uniform()) / sigma_t[channel];
        if (distance >= to_plane) {
            const Vec3 through = glm::exp(-sigma_t * to_plane);
            passage.weight *= through / mean(through);
            passage.down = w.z < 0.0;
            return;
        }
        const Vec3 through = glm::exp(-sigma_t * distance);
        passage.weight *= slab.sigma_s * through / mean(sigma_t * through);
        height = std::clamp(height + w.z * distance, 0.0, slab.thickness);
        w = sample_phase(w, slab.g, random);
        passage.lost = !survives(passage.weight, random);
        if (passage.lost) return;
    }
}

}  // namespace

Slab make_slab(const Medium& medium) {
    Slab slab;
    if (const auto* absorbing = std::get_if<AbsorbingMedium>(&medium)) {
        for (int channel = 0; channel < 3; ++channel) {
            const double tau = absorbing->tau[static_cast<std::size_t>(channel)];
            slab.opaque[channel] = tau <= 0.0;
            slab.sigma_a[channel] = tau <= 0.0 ? 0.0 : std::max(0.0, -std::log(tau));
        }
        return slab;
    }
    const auto& scattering = std::get<ScatteringMedium>(medium);
    slab.sigma_a = to_vec3(scattering.sigma_a);
    slab.sigma_s = to_vec3(scattering.sigma_s);
    slab.g = scattering.g;
    slab.thickness = scattering.thickness;
    return slab;
}

Vec3 sample_phase(const Vec3& direction, double g, RandomStream& random) {
    if (std::abs(g) < kIsotropic) return sample_sphere(random);
    const DiskPoint point = sample_disk(random);
    const double ratio = (1.0 - g * g) / (1.0 + g - 2.0 * g * point.squared_radius);
    const double cosine = std::clamp((1.0 + g * g - ratio * ratio) / (2.0 * g), -1.0, 1.0);
    const double scale = std::sqrt((1.0 - cosine * cosine) / point.squared_radius);
    const Vec3 helper = std::abs(direction.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
    const Vec3 x = glm::normalize(glm::cross(helper, direction));
    const Vec3 y = glm::cross(direction, x);
    return glm::normalize(scale * point.x * x + scale * point.y * y + cosine * direction);
}

Passage pass_slab(const Slab& slab, const Vec3& direction, RandomStream& random) {
    Passage passage{direction, Vec3{1.0}, direction.z < 0.0, false};
    for (int channel = 0; channel < 3; ++channel)
        if (slab.opaque[channel]) passage.weight[channel] = 0.0;
    if (slab.scatters()) {
        scatter_through(slab, passage, random);
    } else {
        const double height = direction.z < 0.0 ? slab.thickness : 0.0;
        passage.weight *= glm::exp(-slab.sigma_a * path_to_plane(slab, direction, height));
    }
    return passage;
}

}  // namespace lacquer::simulator
