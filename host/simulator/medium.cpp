#include "simulator/medium.h"

#include <algorithm>
#include <cmath>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <numbers>

namespace lacquer::simulator {

namespace {

constexpr double kExtinguished = 1e-9;

Vec3 to_vec3(const Rgb& rgb) {
    return {rgb[0], rgb[1], rgb[2]};
}

double mean(const Vec3& v) {
    return (v.x + v.y + v.z) / 3.0;
}

double largest(const Vec3& v) {
    return std::max({v.x, v.y, v.z});
}

// Keeps the expectation of what a faint walk carries while ending most of them.
bool roulette(Vec3& weight, RandomStream& random) {
    const double survival = std::min(1.0, largest(weight) * 10.0);
    if (random.uniform() >= survival) return false;
    weight /= survival;
    return true;
}

}  // namespace

bool Slab::clear() const {
    return sigma_a == Vec3{0.0} && sigma_s == Vec3{0.0} && !opaque[0] && !opaque[1] && !opaque[2];
}

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
    double cosine = 2.0 * random.uniform() - 1.0;
    if (std::abs(g) > 1e-3) {  // below, the inverse loses digits and the phase is isotropic
        const double ratio = (1.0 - g * g) / (1.0 + g * cosine);
        cosine = std::clamp((1.0 + g * g - ratio * ratio) / (2.0 * g), -1.0, 1.0);
    }
    const double sine = std::sqrt(1.0 - cosine * cosine);
    const double phi = 2.0 * std::numbers::pi * random.uniform();
    const Vec3 helper = std::abs(direction.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
    const Vec3 x = glm::normalize(glm::cross(helper, direction));
    const Vec3 y = glm::cross(direction, x);
    return glm::normalize(sine * std::cos(phi) * x + sine * std::sin(phi) * y + cosine * direction);
}

Passage pass_slab(const Slab& slab, const Vec3& direction, RandomStream& random) {
    Passage passage{direction, Vec3{1.0}, direction.z < 0.0, false};
    for (int channel = 0; channel < 3; ++channel)
        if (slab.opaque[channel]) passage.weight[channel] = 0.0;
    if (!slab.scatters()) {
        passage.weight *= glm::exp(-slab.sigma_a * (slab.thickness / std::abs(direction.z)));
        passage.lost = largest(passage.weight) < kExtinguished;
        return passage;
    }
    // One walk serves three channels: the distance is drawn from the extinction of one of them at
    // random, and the balance heuristic over all three keeps every weight bounded.
    const Vec3 sigma_t = slab.sigma_a + slab.sigma_s;
    double height = direction.z < 0.0 ? slab.thickness : 0.0;
    Vec3 w = direction;
    for (;;) {
        const double to_plane = (w.z < 0.0 ? -height : slab.thickness - height) / w.z;
        const int channel = std::min(static_cast<int>(3.0 * random.uniform()), 2);
        const double rate = sigma_t[channel];
        const double distance = rate > 0.0 ? -std::log(random.uniform()) / rate : HUGE_VAL;
        if (distance >= to_plane) {
            const Vec3 through = glm::exp(-sigma_t * to_plane);
            passage.weight *= through / mean(through);
            passage.down = w.z < 0.0;
            break;
        }
        const Vec3 through = glm::exp(-sigma_t * distance);
        passage.weight *= slab.sigma_s * through / mean(sigma_t * through);
        height += w.z * distance;
        w = sample_phase(w, slab.g, random);
        if (largest(passage.weight) < 0.1 && !roulette(passage.weight, random)) {
            passage.lost = true;
            break;
        }
    }
    passage.direction = w;
    return passage;
}

}  // namespace lacquer::simulator
