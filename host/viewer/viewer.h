// `lacquer view`: a sphere in a window, its light moved by the mouse, its material and model chosen
// by keys.
#pragma once

#include <cstddef>
#include <filesystem>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/model.h"
#include "lacquer/material.h"

namespace lacquer::viewer {

struct Options {
    std::vector<Material> materials;  // at least one
    std::size_t first_material = 0;
    Model model = Model::coated_exact;  // what model_for (scene.h) makes of it for each material
    std::string device;       // part of a Vulkan device's name, or its index; empty: lavapipe
    bool validation = false;  // Vulkan validation layers; any message is an Error
    int size = 800;           // pixels of either side of the window, in [64, 4096]
    // The direction towards the only light (unit). Without one there is a light that people move,
    // and two dim ones behind the sphere.
    std::optional<glm::vec3> light;
    std::filesystem::path screenshot;  // where the last frame goes; empty: nowhere
    std::optional<int> frames;         // ends after so many; without, when the window is closed
};

// Shows the window until it is closed, or `frames` are drawn. The sphere's diameter is 4/5 of the
// window's shorter side. Throws Error where there is no display or no Vulkan device that can draw
// to it.
void run(const Options& options);

}  // namespace lacquer::viewer
