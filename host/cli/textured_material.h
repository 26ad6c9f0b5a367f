// A material whose numbers come from pictures, at the points of a surface.
#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <string>
#include <vector>

#include "image/image.h"
#include "lacquer/material.h"

namespace lacquer {

class TexturedMaterial {
 public:
    // Reads the material's textures. PNG levels of an albedo are decoded from sRGB, other numbers
    // are used as they stand. Throws Error where a texture cannot be read.
    explicit TexturedMaterial(Material material);

    // The material at `uv` (see image/texture.h), without textures. Throws Error naming the texture
    // where a looked-up number is out of its range.
    Material at(const glm::dvec2& uv) const;

 private:
    struct Texture {
        TextureReference reference;
        std::shared_ptr<const Image> image;
        bool encoded;  // in sRGB
    };

    Material material_;
    std::vector<Texture> textures_;
};

}  // namespace lacquer
