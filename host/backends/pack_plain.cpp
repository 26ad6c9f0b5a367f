#include "backends/pack_plain.h"

#include <glm/vec3.hpp>

#include "shading/plain_parameters.h"

namespace lacquer {

namespace {

// (alpha x, alpha y, `third`, ndf), the ndf as LQ_NDF_* of shader_src/microfacet/facets.glsl.
glm::vec4 facets_row(const Microsurface& facets, double third) {
    return {facets.alpha[0], facets.alpha[1], third, facets.ndf == Ndf::beckmann ? 1.0 : 0.0};
}

glm::vec4 colour_row(const Rgb& colour) {
    return {colour[0], colour[1], colour[2], 0.0};
}

}  // namespace

std::array<glm::vec4, kPlainRows> pack_plain(const Material& material) {
    const PlainParameters plain = plain_parameters(material);
    return {facets_row(plain.coat, plain.coat_eta),
            facets_row(plain.base_facets, static_cast<int>(plain.base_kind)),
            colour_row(plain.albedo), colour_row(plain.eta), colour_row(plain.kappa)};
}

}  // namespace lacquer
