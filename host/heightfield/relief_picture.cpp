#include "heightfield/relief_picture.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

namespace lacquer::heightfield {

namespace {

using simulator::Vec3;

const Vec3 kView = glm::normalize(Vec3{0.0, 0.8, -0.6});  // away from the viewer
const Vec3 kSun = glm::normalize(Vec3{-0.7, 0.1, 0.55});  // towards it
constexpr double kSunlight = 1.1, kSkylight = 0.35;

// Rays per pixel along each side.
constexpr int kSubpixels = 3;

// Above the highest point, on the line of sight through the place `right`, `up` of the picture.
Vec3 eye(const Heightfield& surface, double right, double up) {
    const Vec3 upwards{0.0, 0.6, 0.8};  // in the picture
    const Tile& tile = surface.mesh().tile;
    const Vec3 middle{0.5 * tile.width(), 0.5 * tile.depth(), 0.0};
    const Vec3 place = middle + Vec3{right, 0.0, 0.0} + up * upwards;
    return place + kView * ((surface.mesh().highest + 1.0 - place.z) / kView.z);
}

glm::dvec3 shade(const Heightfield& surface, std::span<const Rgb> colors, double right, double up) {
    const auto hit = surface.look(eye(surface, right, up), kView);
    if (!hit) return glm::dvec3{0.0};
    const Facet& facet = surface.mesh().facets[hit->triangle];
    const double towards_sun = glm::dot(facet.normal, kSun);
    double light = kSkylight * 0.5 * (1.0 + facet.normal.z);
    if (towards_sun > 0.0 && !surface.look(hit->point, kSun)) light += kSunlight * towards_sun;
    const Rgb& color = colors[facet.stratum];
    return light * glm::dvec3{color[0], color[1], color[2]};
}

}  // namespace

Image relief_picture(const Heightfield& surface, std::span<const Rgb> colors,
                     const ReliefView& view) {
    Image image{view.width, view.height};
    const double pixel = view.extent / view.width;
    tbb::parallel_for(0, view.height, [&](int y) {
        for (int x = 0; x < view.width; ++x) {
            glm::dvec3 sum{0.0};
            for (int j = 0; j < kSubpixels; ++j)
                for (int i = 0; i < kSubpixels; ++i)
                    sum += shade(surface, colors,
                                 pixel * (x + (i + 0.5) / kSubpixels - 0.5 * view.width),
                                 pixel * (0.5 * view.height - y - (j + 0.5) / kSubpixels));
            image.at(x, y) = glm::vec4{glm::vec3{sum / double(kSubpixels * kSubpixels)}, 1.0f};
        }
    });
    return image;
}

std::vector<glm::dvec2> relief_profile(const Heightfield& surface, double extent, int points) {
    const FacetMesh& mesh = surface.mesh();
    std::vector<glm::dvec2> profile;
    for (int point = 0; point < points; ++point) {
        const double x = extent * point / (points - 1);
        const double from = 0.5 * (mesh.tile.width() - extent);
        const auto hit =
            surface.look({from + x, 0.5 * mesh.tile.depth(), mesh.highest + 1.0}, {0.0, 0.0, -1.0});
        if (hit) profile.emplace_back(x, hit->point.z);
    }
    return profile;
}

}  // namespace lacquer::heightfield
