// A window of the desktop (GLFW), and what people do in it.
#pragma once

#include <vulkan/vulkan_core.h>

#include <functional>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

struct GLFWwindow;

namespace lacquer::viewer {

enum class Key { previous, next, model, rim_lights, close };

struct Input {
    std::function<void(glm::vec2 position)>
        drag;  // button held; share of the window, from top left
    std::function<void(Key key)> press;
    std::function<void(int digit)> digit;  // 0 to 9
    std::function<void()> damage;          // the window was resized or uncovered
};

// One window at a time, on the main thread.
class Window {
 public:
    // Throws Unavailable where there is no display, or it has no Vulkan.
    Window(int size, bool visible);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    std::vector<const char*> vulkan_extensions() const;
    VkSurfaceKHR create_surface(VkInstance instance) const;  // the caller's to destroy

    void set_title(const std::string& title);
    void set_input(Input input) { input_ = std::move(input); }

    // Pixels; (0, 0) while the window is minimised.
    glm::uvec2 size() const;
    bool is_closing() const;
    void close();

    // Delivers input that has come; `wait` first waits for some.
    void handle_events(bool wait);

 private:
    void report_damage() const;
    void report_drag() const;

    GLFWwindow* window_ = nullptr;
    Input input_;
};

}  // namespace lacquer::viewer
