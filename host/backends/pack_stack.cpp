#include "backends/pack_stack.h"

#include "backends/pack_row.h"
#include "material/numbers.h"
#include "shading/stack_parameters.h"

namespace lacquer {

std::array<glm::vec4, kStackRows> pack_stack(const Material& material, Model model) {
    const StackParameters stack = stack_parameters(as_shaders_read(material), model);
    const bool conducts = stack.base_kind == StackParameters::BaseKind::conductor;
    std::array<glm::vec4, kStackRows> rows{};
    const glm::vec4 facets = facets_row(stack.base_facets, 0.0);
    rows[0] = {static_cast<float>(stack.layers.size()), static_cast<int>(stack.base_kind), facets.x,
               facets.y};
    rows[1] = colour_row(conducts ? stack.eta : stack.albedo, facets.w);
    rows[2] = colour_row(stack.kappa);
    for (std::size_t n = 0; n < stack.layers.size(); ++n) {
        const StackParameters::Layer& layer = stack.layers[n];
        rows[3 + 3 * n] = facets_row(layer.microsurface, layer.index);
        rows[4 + 3 * n] = colour_row(layer.absorption, layer.g);
        rows[5 + 3 * n] = colour_row(layer.scattering);
    }
    return rows;
}

}  // namespace lacquer
