#include "viewer/viewer.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/file.h"
#include "image/png.h"
#include "viewer/renderer.h"
#include "viewer/scene.h"
#include "viewer/window.h"

namespace lacquer::viewer {

namespace {

// A window that changes under every frame is not a window.
constexpr int kMaxAttempts = 100;

// The scene, and what people do to it.
class Exhibit {
 public:
    Exhibit(const Options& options, Window& window) : options_{&options}, window_{&window} {
        wanted_ = options.model;
        scene_.light = options.light.value_or(default_light());
        scene_.rim_lights = !options.light;
        show(options.first_material);
    }

    const Scene& scene() const { return scene_; }
    bool has_changed() const { return changed_; }
    void was_drawn() { changed_ = false; }
    void damage() { changed_ = true; }

    void drag(glm::vec2 share) {
        const glm::uvec2 size = window_->size();
        scene_.light = light_with_highlight_at(share * glm::vec2{size}, size.x, size.y);
        changed_ = true;
    }

    void press(Key key) {
        const std::size_t count = options_->materials.size();
        switch (key) {
            case Key::previous:
                return show((material_ + count - 1) % count);
            case Key::next:
                return show((material_ + 1) % count);
            case Key::model:
                wanted_ = next_model(options_->materials[material_], scene_.model);
                return show(material_);
            case Key::close:
                return window_->close();
            case Key::rim_lights:
                scene_.rim_lights = !scene_.rim_lights;
                changed_ = true;
        }
    }

    // 1 is the first material and 0 the tenth.
    void digit(int digit) {
        const std::size_t index = digit == 0 ? 9 : static_cast<std::size_t>(digit) - 1;
        if (index < options_->materials.size()) show(index);
    }

 private:
    void show(std::size_t index) {
        const Material& material = options_->materials[index];
        material_ = index;
        scene_.model = model_for(material, wanted_);
        scene_.surface = surface_of(material, scene_.model);
        window_->set_title(fmt::format("Lacquer: {}, {}", material.name, model_name(scene_.model)));
        changed_ = true;
    }

    const Options* options_;
    Window* window_;
    std::size_t material_ = 0;
    Model wanted_ = Model::plain;
    Scene scene_;
    bool changed_ = true;
};

void save_screenshot(Renderer& renderer, const Scene& scene, Window& window,
                     const std::filesystem::path& file) {
    for (int attempt = 0; attempt < kMaxAttempts; ++attempt) {
        if (const auto screenshot = renderer.capture(scene)) {
            write_file(file, encode_png(screenshot->width, screenshot->height, screenshot->pixels));
            return;
        }
        window.handle_events(false);
    }
    throw Error{fmt::format("no frame could be drawn for '{}'", file.string())};
}

}  // namespace

void run(const Options& options) {
    const bool capture = !options.screenshot.empty();
    Window window{options.size, !capture};
    Renderer renderer{window, options.device, options.validation};
    Exhibit exhibit{options, window};
    window.set_input({[&](glm::vec2 share) { exhibit.drag(share); },
                      [&](Key key) { exhibit.press(key); },
                      [&](int digit) { exhibit.digit(digit); }, [&] { exhibit.damage(); }});
    const bool ends = capture || options.frames;
    int left = options.frames.value_or(1) - (capture ? 1 : 0);  // the last one is the screenshot
    while (!window.is_closing() && (!ends || left > 0)) {
        if ((ends || exhibit.has_changed()) && renderer.draw(exhibit.scene())) {
            exhibit.was_drawn();
            --left;
        }
        const bool minimised = window.size() == glm::uvec2{0, 0};
        window.handle_events(minimised || (!ends && !exhibit.has_changed()));
    }
    if (capture) save_screenshot(renderer, exhibit.scene(), window, options.screenshot);
}

}  // namespace lacquer::viewer
