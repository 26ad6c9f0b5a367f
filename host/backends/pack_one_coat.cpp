#include "backends/pack_one_coat.h"

#include "backends/pack_row.h"
#include "material/numbers.h"
#include "shading/one_coat_parameters.h"

namespace lacquer {

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
