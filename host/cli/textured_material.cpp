#include "cli/textured_material.h"

#include <fmt/format.h>

#include <map>

#include "core/error.h"
#include "image/display.h"
#include "image/image_file.h"
#include "image/texture.h"
#include "material/numbers.h"

namespace lacquer {

namespace {

bool is_color(const std::string& pointer) {
    return pointer.find("/albedo") != std::string::npos;
}

}  // namespace

TexturedMaterial::TexturedMaterial(Material material) : material_{std::move(material)} {
    std::map<std::filesystem::path, std::shared_ptr<const Image>> images;
    for (const TextureReference& reference : material_.textures) {
        auto& image = images[reference.file];
        if (!image) image = std::make_shared<const Image>(read_image(reference.file));
        textures_.push_back(
            {reference, image, is_display_format(reference.file) && is_color(reference.pointer)});
    }
    material_.textures.clear();
}

Material TexturedMaterial::at(const glm::dvec2& uv) const {
    Material result = material_;
    for (const Texture& texture : textures_) {
        const TextureReference& reference = texture.reference;
        double value = sample_texture(*texture.image, reference.channel, uv);
        if (texture.encoded) value = srgb_decode(value);
        try {
            result = with_number(result, reference.pointer, value);
        } catch (const Error& error) {
            throw Error{fmt::format("texture '{}', channel {}, at u {:.3f}, v {:.3f}: {}",
                                    reference.file.string(), reference.channel, uv.x, uv.y,
                                    error.what())};
        }
    }
    return result;
}

}  // namespace lacquer
