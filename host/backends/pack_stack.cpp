#include "backends/pack_stack.h"

#include <algorithm>

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
    std::ranges::transform(layer_rows(stack), rows.begin() + 3, [](const std::array<double, 4>& r) {
        return glm::vec4{r[0], r[1], r[2], r[3]};
    });
    return rows;
}

}  // namespace lacquer
