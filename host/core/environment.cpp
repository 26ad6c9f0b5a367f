#include "core/environment.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <ranges>

namespace lacquer {

std::optional<std::string> environment_variable(const std::string& name) {
    const char* value = std::getenv(name.c_str());
    if (value == nullptr || *value == '\0') return std::nullopt;
    return std::string{value};
}

ScopedEnvironment::~ScopedEnvironment() {
    for (const Saved& saved : saved_ | std::views::reverse) {
        if (saved.value)
            setenv(saved.name.c_str(), saved.value->c_str(), 1);
        else
            unsetenv(saved.name.c_str());
    }
}

void ScopedEnvironment::save(const std::string& name) {
    const char* value = std::getenv(name.c_str());
    saved_.push_back({name, value ? std::optional<std::string>{value} : std::nullopt});
}

void ScopedEnvironment::set(const std::string& name, const std::string& value) {
    save(name);
    setenv(name.c_str(), value.c_str(), 1);
}

void ScopedEnvironment::unset(const std::string& name) {
    save(name);
    unsetenv(name.c_str());
}

void ensure_runtime_folder() {
    if (environment_variable("XDG_RUNTIME_DIR")) return;
    std::error_code ignored;  // a driver's complaint is no reason to stop
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path(ignored) / fmt::format("lacquer-runtime-{}", getuid());
    mkdir(folder.c_str(), S_IRWXU);
    setenv("XDG_RUNTIME_DIR", folder.c_str(), 1);
}

}  // namespace lacquer
