// The process's environment variables: reading them, and changing them for a while.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lacquer {

// The variable's value; nothing where it is absent or empty.
std::optional<std::string> environment_variable(const std::string& name);

// Changes environment variables and puts them back when it goes. The environment belongs to the
// whole process: use it while no other thread reads it.
class ScopedEnvironment {
 public:
    ScopedEnvironment() = default;
    ~ScopedEnvironment();
    ScopedEnvironment(const ScopedEnvironment&) = delete;
    ScopedEnvironment& operator=(const ScopedEnvironment&) = delete;

    void set(const std::string& name, const std::string& value);
    void unset(const std::string& name);

 private:
    struct Saved {
        std::string name;
        std::optional<std::string> value;  // as it was, even if empty
    };

    void save(const std::string& name);

    std::vector<Saved> saved_;
};

// Gives the process an XDG_RUNTIME_DIR where it has none: graphics drivers complain without.
void ensure_runtime_folder();

}  // namespace lacquer
