#include "study/layered/studio.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace lacquer::study {

namespace {

constexpr double kEdge = 0.025;   // width of an edge, in tangents of angles
constexpr double kFrame = 0.035;  // half the width of the bar between two panes

// From 0 below -kEdge / 2 to 1 above it.
double step(double x) {
    const double t = std::clamp(x / kEdge + 0.5, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

// A rectangle about a direction, upright.
struct Window {
    glm::dvec3 centre;
    double half_width, half_height;  // tangents of angles
    double radiance;
    bool has_panes;
};

const Window kWindows[] = {
    {glm::normalize(glm::dvec3{-0.55, 0.6, 0.58}), 0.38, 0.32, 3.5, true},
    {glm::normalize(glm::dvec3{0.0, 0.62, -0.78}), 0.75, 0.4, 2.5, true},
    {glm::normalize(glm::dvec3{0.8, 0.15, 0.55}), 0.07, 0.5, 3.0, false},
};

// The share of the window seen along w.
double seen(const Window& window, const glm::dvec3& w) {
    const double along = glm::dot(w, window.centre);
    if (along <= 0.0) return 0.0;
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3{0.0, 1.0, 0.0}, window.centre));
    const double x = std::abs(glm::dot(w, right)) / along;
    const double y = std::abs(glm::dot(w, glm::cross(window.centre, right))) / along;
    const double inside = step(window.half_width - x) * step(window.half_height - y);
    return window.has_panes ? inside * step(x - kFrame) * step(y - kFrame) : inside;
}

}  // namespace

double studio(const glm::dvec3& w) {
    constexpr double kFloor = 0.12, kWall = 0.35, kCeiling = 0.55;
    double light = kFloor + (kWall + (kCeiling - kWall) * std::max(w.y, 0.0) - kFloor) * step(w.y);
    for (const Window& window : kWindows) light += (window.radiance - light) * seen(window, w);
    return light;
}

double white_furnace(const glm::dvec3&) {
    return 1.0;
}

}  // namespace lacquer::study
