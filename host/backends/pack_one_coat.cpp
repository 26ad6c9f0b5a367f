#include "backends/pack_one_coat.h"

#include <algorithm>
#include <glm/vec3.hpp>
#include <limits>

#include "material/numbers.h"
#include "shading/one_coat_parameters.h"

namespace lacquer {

namespace {

// (alpha x, alpha y, `third`, ndf), the ndf as LQ_NDF_* of shader_src/microfacet/facets.glsl.
glm::vec4 facets_row(const Microsurface& facets, double third) {
    return {facets.alpha[0], facets.alpha[1], third, facets.ndf == Ndf::beckmann ? 1.0 : 0.0};
}

// Infinities, which not every language has, become the largest float.
glm::vec4 colour_row(const Rgb& colour) {
    constexpr double kLargest = std::numeric_limits<float>::max();
    return {std::min(colour[0], kLargest), std::min(colour[1], kLargest),
            std::min(colour[2], kLargest), 0.0};
}

}  // namespace

std::array<glm::vec4, kOneCoatRows> pack_one_coat(const Material& material, Model model) {
    // Rounded before logarithms are taken of what is rounded: so does the reference.
    const OneCoatParameters surface = one_coat_parameters(as_shaders_read(material), model);
    return {facets_row(surface.coat, surface.coat_eta),
            facets_row(surface.base_facets, static_cast<int>(surface.base_kind)),
            colour_row(surface.albedo),
            colour_row(surface.eta),
            colour_row(surface.kappa),
            colour_row(surface.optical_depth)};
}

}  // namespace lacquer
