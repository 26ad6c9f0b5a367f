#include "lacquer/bsdf.h"
#include "shading/glsl.h"

namespace lacquer {

void use_table_texels(const glm::vec4* texels) {
    glsl::table_texels = texels;
}

}  // namespace lacquer
