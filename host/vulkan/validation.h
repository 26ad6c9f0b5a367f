// What the validation layers say.
#pragma once

#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace lacquer::vulkan {

// Collects messages from whichever thread the driver sends them on.
class ValidationLog {
 public:
    void add(std::string message) {
        const std::lock_guard lock{mutex_};
        messages_.push_back(std::move(message));
    }

    // The messages since the last call.
    std::vector<std::string> take() {
        const std::lock_guard lock{mutex_};
        return std::exchange(messages_, {});
    }

 private:
    std::mutex mutex_;
    std::vector<std::string> messages_;
};

}  // namespace lacquer::vulkan
