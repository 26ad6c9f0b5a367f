#include "compare/grids.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <numbers>

namespace lacquer {

namespace {

constexpr double kPi = std::numbers::pi;

glm::vec4 rounded(const glm::dvec3& w) {
    return {static_cast<float>(w.x), static_cast<float>(w.y), static_cast<float>(w.z), 0.0f};
}

// Centre of pixel (x, y) on the disk of radius 1 that fills the picture; y points up.
glm::dvec2 disk_position(int x, int y, int size) {
    return {(2.0 * x + 1.0) / size - 1.0, 1.0 - (2.0 * y + 1.0) / size};
}

QueryGrid empty_grid(const std::string& name, Kernel kernel, int size) {
    QueryGrid grid;
    grid.name = name;
    grid.kernel = kernel;
    grid.width = grid.height = size;
    return grid;
}

using PixelVisitor = std::function<void(const glm::dvec2& position)>;

// Lists the pixels inside the disk in `grid` and calls `visit` with each.
void visit_disk(QueryGrid& grid, const PixelVisitor& visit) {
    for (int y = 0; y < grid.height; ++y) {
        for (int x = 0; x < grid.width; ++x) {
            const glm::dvec2 position = disk_position(x, y, grid.width);
            if (glm::dot(position, position) >= 1.0) continue;
            grid.pixels.push_back(static_cast<std::uint32_t>(y * grid.width + x));
            visit(position);
        }
    }
}

// Lambert's azimuthal equal-area projection of the upper hemisphere, the disk scaled to radius 1:
// cos(theta) = 1 - r^2.
glm::dvec3 equal_area_direction(const glm::dvec2& position) {
    const double r2 = glm::dot(position, position);
    const double scale = std::sqrt(2.0 - r2);
    return {position.x * scale, position.y * scale, 1.0 - r2};
}

glm::dvec3 sphere_normal(const glm::dvec2& position) {
    return {position.x, position.y, std::sqrt(1.0 - glm::dot(position, position))};
}

// `w` in the frame at `normal` whose tangent runs along the parallel. The poles, where there is no
// such tangent, are never at a pixel's centre: they lie on the disk's edge.
glm::dvec3 to_sphere_frame(const glm::dvec3& normal, const glm::dvec3& w) {
    const glm::dvec3 tangent = glm::normalize(glm::dvec3{normal.z, 0.0, -normal.x});
    return {glm::dot(w, tangent), glm::dot(w, glm::cross(normal, tangent)), glm::dot(w, normal)};
}

}  // namespace

Query query_of(const QueryGrid& grid, std::size_t index) {
    const auto direction = [&](std::size_t row) { return glm::vec3{grid.inputs[row]}; };
    if (grid.kernel != Kernel::slice) return {direction(2 * index), direction(2 * index + 1)};
    const float* wo = grid.parameters.wo;
    return {direction(index), {wo[0], wo[1], wo[2]}};
}

int compared_components(Kernel kernel) {
    return kernel == Kernel::sphere ? 3 : 4;
}

glm::dvec3 direction_at(double theta_deg) {
    if (theta_deg == 90.0) return {1.0, 0.0, 0.0};
    const double theta = theta_deg * kPi / 180.0;
    return {std::sin(theta), 0.0, std::cos(theta)};
}

QueryGrid slice_grid(const std::string& name, const glm::dvec3& wo, int size) {
    QueryGrid grid = empty_grid(name, Kernel::slice, size);
    visit_disk(grid, [&](const glm::dvec2& position) {
        grid.inputs.push_back(rounded(equal_area_direction(position)));
    });
    const glm::vec4 viewer = rounded(wo);
    for (int axis = 0; axis < 3; ++axis) grid.parameters.wo[axis] = viewer[axis];
    return grid;
}

QueryGrid sphere_grid(const std::string& name, const glm::dvec3& light, int size) {
    QueryGrid grid = empty_grid(name, Kernel::sphere, size);
    visit_disk(grid, [&](const glm::dvec2& position) {
        const glm::dvec3 normal = sphere_normal(position);
        grid.inputs.push_back(rounded(to_sphere_frame(normal, light)));
        grid.inputs.push_back(rounded(to_sphere_frame(normal, {0.0, 0.0, 1.0})));
    });
    for (int channel = 0; channel < 3; ++channel)
        grid.parameters.radiance[channel] = static_cast<float>(kPi);
    return grid;
}

glm::dvec2 sphere_uv(const QueryGrid& grid, std::size_t index) {
    const int pixel = static_cast<int>(grid.pixels[index]);
    const glm::dvec3 normal =
        sphere_normal(disk_position(pixel % grid.width, pixel / grid.width, grid.width));
    return {0.5 + std::atan2(normal.x, normal.z) / (2.0 * kPi), 0.5 + std::asin(normal.y) / kPi};
}

Image paint(const QueryGrid& grid, std::span<const glm::dvec4> rows) {
    Image image{grid.width, grid.height};
    for (std::size_t i = 0; i < grid.pixels.size(); ++i)
        image.pixels[grid.pixels[i]] = glm::vec4{glm::dvec4{glm::dvec3{rows[i]}, 1.0}};
    return image;
}

std::vector<QueryGrid> default_suite() {
    std::vector<QueryGrid> grids;
    for (const double theta_deg : kSliceElevations_deg)
        grids.push_back(
            slice_grid(fmt::format("slice {}", theta_deg), direction_at(theta_deg), kSliceSize));
    grids.push_back(sphere_grid("sphere", default_light(), kSphereSize));
    return grids;
}

glm::dvec3 default_light() {
    return glm::normalize(glm::dvec3{-0.5, 0.65, 0.6});
}

}  // namespace lacquer
