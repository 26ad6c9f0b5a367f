#include "vulkan/driver.h"

#include <fmt/format.h>
#include <sys/utsname.h>

#include <array>

#include "core/error.h"

namespace lacquer::vulkan {

namespace fs = std::filesystem;

namespace {

// Where the Vulkan loader looks for drivers on Linux.
constexpr std::array kManifestFolders{"/usr/local/etc/vulkan/icd.d", "/etc/vulkan/icd.d",
                                      "/usr/local/share/vulkan/icd.d", "/usr/share/vulkan/icd.d"};

bool is_lavapipe(const fs::path& manifest) {
    const std::string name = manifest.filename().string();
    return name.starts_with("lvp_icd.") && name.ends_with(".json");
}

std::string machine_name() {
    utsname machine{};
    uname(&machine);
    return machine.machine;
}

}  // namespace

std::optional<fs::path> lavapipe_manifest() {
    const std::string machine = machine_name();
    std::optional<fs::path> found;
    for (const fs::path folder : kManifestFolders) {
        std::error_code absent;
        for (const auto& entry : fs::directory_iterator{folder, absent}) {
            if (!is_lavapipe(entry.path())) continue;
            // Several architectures may be installed side by side.
            if (entry.path().filename().string().find(machine) != std::string::npos)
                return entry.path();
            found = entry.path();
        }
    }
    return found;
}

std::optional<std::string> users_driver_choice() {
    for (const char* variable : {"VK_DRIVER_FILES", "VK_ICD_FILENAMES"})
        if (const auto value = environment_variable(variable))
            return fmt::format("{}={}", variable, *value);
    return std::nullopt;
}

void show_default_driver(ScopedEnvironment& environment) {
    if (users_driver_choice()) return;
    const auto manifest = lavapipe_manifest();
    if (!manifest)
        throw Unavailable{"Mesa's software Vulkan driver lavapipe is not installed",
                          "apt-get install mesa-vulkan-drivers"};
    show_driver(environment, *manifest);
}

void show_all_drivers(ScopedEnvironment& environment) {
    if (users_driver_choice()) return;
    // Set but empty, either variable makes the loader find no driver at all.
    environment.unset("VK_DRIVER_FILES");
    environment.unset("VK_ICD_FILENAMES");
}

void show_driver(ScopedEnvironment& environment, const fs::path& manifest) {
    environment.unset("VK_DRIVER_FILES");  // takes precedence over VK_ICD_FILENAMES
    environment.set("VK_ICD_FILENAMES", manifest.string());
}

}  // namespace lacquer::vulkan
