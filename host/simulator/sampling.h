// Points and directions drawn uniformly, without a sine or cosine.
// Based on: Marsaglia 1972, Choosing a Point from the Surface of a Sphere
#pragma once

#include <cmath>
#include <glm/vec3.hpp>

#include "simulator/random.h"

namespace lacquer::simulator {

using Vec3 = glm::dvec3;

// A point of the unit disk. Its squared radius is uniform in (0, 1) whatever its azimuth, so that
// one point gives two independent numbers.
struct DiskPoint {
    double x, y;
    double squared_radius;
};

inline DiskPoint sample_disk(RandomStream& random) {
    for (;;) {
        const double x = 2.0 * random.uniform() - 1.0;
        const double y = 2.0 * random.uniform() - 1.0;
        const double squared_radius = x * x + y * y;
        if (squared_radius < 1.0 && squared_radius > 0.0) return {x, y, squared_radius};
    }
}

// Two independent numbers of density exp(-x^2) / sqrt(pi).
struct BellPair {
    double x, y;
};

inline BellPair sample_bell_pair(RandomStream& random) {
    const DiskPoint point = sample_disk(random);
    const double scale = std::sqrt(-std::log(point.squared_radius) / point.squared_radius);
    return {point.x * scale, point.y * scale};
}

// Direction of the unit sphere.
inline Vec3 sample_sphere(RandomStream& random) {
    const DiskPoint point = sample_disk(random);
    const double scale = 2.0 * std::sqrt(1.0 - point.squared_radius);
    return {point.x * scale, point.y * scale, 1.0 - 2.0 * point.squared_radius};
}

// Direction of the upper hemisphere, in proportion to its cosine.
inline Vec3 sample_cosine(RandomStream& random) {
    const DiskPoint point = sample_disk(random);
    return {point.x, point.y, std::sqrt(1.0 - point.squared_radius)};
}

}  // namespace lacquer::simulator
