// Draws a scene to a window, frame by frame.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "image/display.h"
#include "viewer/scene.h"
#include "viewer/window.h"

namespace lacquer::viewer {

// What was on the screen; rows from the top.
struct Screenshot {
    int width = 0, height = 0;
    std::vector<DisplayColor> pixels;
};

class Renderer {
 public:
    // See Options for `device` and `validation`. `window` stays the caller's and must outlive it.
    // Throws Unavailable where no device can draw to the window.
    Renderer(const Window& window, const std::string& device, bool validation);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    // Draws and shows `scene`; false where the window had changed under it, or is minimised, and
    // the frame is to be drawn again.
    bool draw(const Scene& scene);

    // The same, and what is then on the screen.
    std::optional<Screenshot> capture(const Scene& scene);

    const std::string& device_name() const;

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace lacquer::viewer
