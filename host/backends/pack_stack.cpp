#include "backends/pack_stack.h"

#include <algorithm>
#include <limits>

#include "material/numbers.h"
#include "shading/stack_parameters.h"

namespace lacquer {

namespace {

// Infinities, which not every language has, become the largest float.
glm::vec4 colour_row(const Rgb& colour, double fourth) {
    constexpr double kLargest = std::numeric_limits<float>::max();
    return {std::min(colour[0], kLargest), std::min(colour[1], kLargest),
            std::min(colour[2], kLargest), fourth};
}

double ndf_number(Ndf ndf) {
    return ndf == Ndf::beckmann ? 1.0 : 0.0;  // LQ_NDF_*
}

}  // namespace

std::array<glm::vec4, kStackRows> pack_stack(const Material& material, Model model) {
    const StackParameters stack = stack_parameters(as_shaders_read(material), model);
    const bool conducts = stack.base_kind == StackParameters::BaseKind::conductor;
    std::array<glm::vec4, kStackRows> rows{};
    rows[0] = {static_cast<float>(stack.layers.size()), static_cast<int>(stack.base_kind),
               stack.base_facets.alpha[0], stack.base_facets.alpha[1]};
    rows[1] = colour_row(conducts ? stack.eta : stack.albedo, ndf_number(stack.base_facets.ndf));
    rows[2] = colour_row(stack.kappa, 0.0);
    for (std::size_t n = 0; n < stack.layers.size(); ++n) {
        const StackParameters::Layer& layer = stack.layers[n];
        rows[3 + 3 * n] = {layer.microsurface.alpha[0], layer.microsurface.alpha[1], layer.index,
                           ndf_number(layer.microsurface.ndf)};
        rows[4 + 3 * n] = colour_row(layer.absorption, layer.g);
        rows[5 + 3 * n] = colour_row(layer.scattering, 0.0);
    }
    return rows;
}

}  // namespace lacquer
