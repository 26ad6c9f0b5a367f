// Which Vulkan drivers the loader is shown. The loader reads the environment whenever an instance
// is created, so the choice is made there and put back afterwards.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/environment.h"

namespace lacquer::vulkan {

// The manifest of Mesa's software driver, the default wherever no other was asked for.
std::optional<std::filesystem::path> lavapipe_manifest();

// The drivers that the user chose through VK_DRIVER_FILES or VK_ICD_FILENAMES, as
// "VARIABLE=VALUE"; nothing where the choice is ours.
std::optional<std::string> users_driver_choice();

// Shows the loader lavapipe alone. The user's own choice stands. Throws Unavailable where the
// user made none and lavapipe is not installed.
void show_default_driver(ScopedEnvironment& environment);

// Shows the loader every installed driver. The user's own choice stands.
void show_all_drivers(ScopedEnvironment& environment);

// Shows the loader the driver of `manifest` alone, whatever the user chose.
void show_driver(ScopedEnvironment& environment, const std::filesystem::path& manifest);

}  // namespace lacquer::vulkan
