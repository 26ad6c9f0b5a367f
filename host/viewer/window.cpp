#include "viewer/window.h"

#define GLFW_INCLUDE_VULKAN
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <optional>

#include "core/error.h"

namespace lacquer::viewer {

namespace {

std::string glfw_error() {
    const char* description = nullptr;
    glfwGetError(&description);
    return description != nullptr ? description : "unknown error";
}

Unavailable no_display() {
    return {fmt::format("no window can be opened ({})", glfw_error()),
            "run it on a desktop, or with xvfb-run where there is none"};
}

std::optional<Key> key_of(int code) {
    switch (code) {
        case GLFW_KEY_LEFT:
        case GLFW_KEY_UP:
            return Key::previous;
        case GLFW_KEY_RIGHT:
        case GLFW_KEY_DOWN:
        case GLFW_KEY_SPACE:
            return Key::next;
        case GLFW_KEY_M:
            return Key::model;
        case GLFW_KEY_R:
            return Key::rim_lights;
        case GLFW_KEY_ESCAPE:
        case GLFW_KEY_Q:
            return Key::close;
        default:
            return std::nullopt;
    }
}

std::optional<int> digit_of(int code) {
    if (code >= GLFW_KEY_0 && code <= GLFW_KEY_9) return code - GLFW_KEY_0;
    if (code >= GLFW_KEY_KP_0 && code <= GLFW_KEY_KP_9) return code - GLFW_KEY_KP_0;
    return std::nullopt;
}

Window& window_of(GLFWwindow* window) {
    return *static_cast<Window*>(glfwGetWindowUserPointer(window));
}

}  // namespace

Window::Window(int size, bool visible) {
    if (glfwInit() == GLFW_FALSE) throw no_display();
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    glfwWindowHint(GLFW_VISIBLE, visible ? GLFW_TRUE : GLFW_FALSE);
    window_ = glfwCreateWindow(size, size, "Lacquer", nullptr, nullptr);
    if (window_ == nullptr) {
        const Unavailable error = no_display();
        glfwTerminate();
        throw error;
    }
    glfwSetWindowUserPointer(window_, this);
    glfwSetKeyCallback(window_, [](GLFWwindow* window, int code, int, int action, int) {
        const Input& input = window_of(window).input_;
        if (action == GLFW_RELEASE) return;
        if (const auto key = key_of(code); key && input.press) input.press(*key);
        if (const auto digit = digit_of(code); digit && input.digit) input.digit(*digit);
    });
    glfwSetMouseButtonCallback(
        window_, [](GLFWwindow* window, int, int, int) { window_of(window).report_drag(); });
    glfwSetCursorPosCallback(
        window_, [](GLFWwindow* window, double, double) { window_of(window).report_drag(); });
    glfwSetWindowRefreshCallback(window_,
                                 [](GLFWwindow* window) { window_of(window).report_damage(); });
    glfwSetFramebufferSizeCallback(
        window_, [](GLFWwindow* window, int, int) { window_of(window).report_damage(); });
}

Window::~Window() {
    glfwDestroyWindow(window_);
    glfwTerminate();
}

std::vector<const char*> Window::vulkan_extensions() const {
    std::uint32_t count = 0;
    const char** names = glfwGetRequiredInstanceExtensions(&count);
    if (names == nullptr)
        throw Unavailable{fmt::format("this display has no Vulkan ({})", glfw_error()),
                          "apt-get install libvulkan1 mesa-vulkan-drivers"};
    return {names, names + count};
}

VkSurfaceKHR Window::create_surface(VkInstance instance) const {
    VkSurfaceKHR surface = VK_NULL_HANDLE;
    if (glfwCreateWindowSurface(instance, window_, nullptr, &surface) != VK_SUCCESS)
        throw Error{fmt::format("Vulkan cannot draw to the window: {}", glfw_error())};
    return surface;
}

void Window::set_title(const std::string& title) {
    glfwSetWindowTitle(window_, title.c_str());
}

glm::uvec2 Window::size() const {
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    return {width, height};
}

bool Window::is_closing() const {
    return glfwWindowShouldClose(window_) == GLFW_TRUE;
}

void Window::close() {
    glfwSetWindowShouldClose(window_, GLFW_TRUE);
}

void Window::handle_events(bool wait) {
    if (wait)
        glfwWaitEvents();
    else
        glfwPollEvents();
}

void Window::report_damage() const {
    if (input_.damage) input_.damage();
}

void Window::report_drag() const {
    if (glfwGetMouseButton(window_, GLFW_MOUSE_BUTTON_LEFT) != GLFW_PRESS || !input_.drag) return;
    int width = 0, height = 0;
    glfwGetWindowSize(window_, &width,
                      &height);  // cursors are measured in its units, not in pixels
    double x = 0.0, y = 0.0;
    glfwGetCursorPos(window_, &x, &y);
    if (width > 0 && height > 0) input_.drag(glm::vec2{x / width, y / height});
}

}  // namespace lacquer::viewer
