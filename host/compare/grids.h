// The queries that backends are compared on: slices of the hemisphere and lit spheres. Directions
// are computed in double and rounded once to the floats that every backend, the reference included,
// then gets.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <string>
#include <vector>

#include "backends/kernel.h"
#include "image/image.h"

namespace lacquer {

// A picture's worth of queries. Pixels that `pixels` does not list carry none.
struct QueryGrid {
    std::string name;  // "slice 60", "sphere"
    Kernel kernel = Kernel::slice;
    int width = 0, height = 0;
    std::vector<std::uint32_t> pixels;  // of each query, y * width + x, rows from the top
    std::vector<glm::vec4> inputs;      // input_rows(kernel) per query
    KernelParameters parameters;

    std::size_t query_count() const { return pixels.size(); }
};

struct Query {
    glm::vec3 wi{}, wo{};
};

// The directions of query `index`, as `lacquer eval` takes them.
Query query_of(const QueryGrid& grid, std::size_t index);

// How many numbers of a result row are compared: f and pdf of a slice, radiance of a sphere.
int compared_components(Kernel kernel);

// The direction at `theta_deg` from the normal, towards +x.
glm::dvec3 direction_at(double theta_deg);

// All light directions for the viewer `wo` (unit): the hemisphere in Lambert's azimuthal equal-area
// projection, so that every pixel stands for the same solid angle, on the unit disk of a picture of
// `size` x `size` pixels; x to the right, y up.
QueryGrid slice_grid(const std::string& name, const glm::dvec3& wo, int size);

// A sphere in orthographic projection, seen along -z, under one light from `light` (unit) whose
// irradiance is pi across the beam: a white Lambertian surface facing it has radiance 1. Local
// tangents run east along the parallels; the poles are up and down.
QueryGrid sphere_grid(const std::string& name, const glm::dvec3& light, int size);

// Where query `index` of a sphere grid lies on it: longitude and latitude as (u, v) in [0, 1], the
// meridian facing the viewer at u = 1/2, the lower pole at v = 0.
glm::dvec2 sphere_uv(const QueryGrid& grid, std::size_t index);

// A picture of one value per query, alpha 1 where there is one.
Image paint(const QueryGrid& grid, std::span<const glm::dvec4> rows);

// The suite `default`: eight slices from the normal to 89.5 degrees and a sphere.
std::vector<QueryGrid> default_suite();

inline constexpr double kSliceElevations_deg[] = {0, 15, 30, 45, 60, 75, 85, 89.5};
inline constexpr int kSliceSize = 128;
inline constexpr int kSphereSize = 256;

// From above the viewer's left shoulder: highlight, half shade and terminator are all in the
// picture.
glm::dvec3 default_light();

}  // namespace lacquer
