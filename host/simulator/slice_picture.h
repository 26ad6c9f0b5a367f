// The picture of a hemisphere in Lambert's azimuthal equal-area projection, cos_theta = 1 - r^2 on
// the unit disk: every pixel stands for the same solid angle.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <vector>

#include "simulator/sampling.h"

namespace lacquer::simulator {

class SlicePicture {
 public:
    explicit SlicePicture(int size) : size_{size} {}

    std::size_t pixel_count() const { return static_cast<std::size_t>(size_ * size_); }

    // Solid angle of a whole pixel.
    double solid_angle() const { return 8.0 / (static_cast<double>(size_) * size_); }

    // Position on the disk of a point of pixel `index`, (0.5, 0.5) its centre.
    glm::dvec2 position(std::size_t index, double x, double y) const {
        const auto column = static_cast<double>(index % static_cast<std::size_t>(size_));
        const auto row = static_cast<double>(index / static_cast<std::size_t>(size_));
        return {2.0 * (column + x) / size_ - 1.0, 1.0 - 2.0 * (row + y) / size_};
    }

    // Negative outside the disk.
    static double cosine(const glm::dvec2& p) { return 1.0 - p.x * p.x - p.y * p.y; }

    static Vec3 direction(const glm::dvec2& p) {
        const double scale = std::sqrt(1.0 + cosine(p));
        return {p.x * scale, p.y * scale, cosine(p)};
    }

    // Of a unit direction above the surface; at the edge of the disk, the nearest within the
    // picture.
    std::size_t pixel_of(const Vec3& w) const {
        const double scale = 1.0 / std::sqrt(1.0 + w.z);
        const int column = static_cast<int>(0.5 * (1.0 + w.x * scale) * size_);
        const int row = static_cast<int>(0.5 * (1.0 - w.y * scale) * size_);
        return static_cast<std::size_t>(std::clamp(row, 0, size_ - 1) * size_ +
                                        std::clamp(column, 0, size_ - 1));
    }

    // Integral of the cosine over the part of a pixel that is on the disk.
    double projected_solid_angle(std::size_t index) const {
        constexpr int kSteps = 16;
        double sum = 0.0;
        for (int j = 0; j < kSteps; ++j)
            for (int i = 0; i < kSteps; ++i)
                sum +=
                    std::max(0.0, cosine(position(index, (i + 0.5) / kSteps, (j + 0.5) / kSteps)));
        return solid_angle() * sum / (kSteps * kSteps);
    }

    // Pixels whose centre is on the disk.
    std::vector<std::size_t> visible_pixels() const {
        std::vector<std::size_t> visible;
        for (std::size_t index = 0; index < pixel_count(); ++index)
            if (cosine(position(index, 0.5, 0.5)) > 0.0) visible.push_back(index);
        return visible;
    }

 private:
    int size_;
};

}  // namespace lacquer::simulator
