#include "backends/pack_coated.h"

#include "material/numbers.h"
#include "shading/one_coat_parameters.h"

namespace lacquer {

std::array<glm::vec4, kCoatedRows> pack_coated(const Material& material, Model model) {
    const OneCoatParameters surface = one_coat_parameters(as_shaders_read(material), model);
    const Rgb tau = transmittance(surface);
    const double base_lobe = model == Model::coated_ggx ? 1.0 : 0.0;   // LQ_BASE_LOBE_*
    const double ndf = surface.coat.ndf == Ndf::beckmann ? 1.0 : 0.0;  // LQ_NDF_*
    return {glm::vec4{surface.coat.alpha[0], surface.coat.alpha[1], surface.coat_eta, ndf},
            glm::vec4{tau[0], tau[1], tau[2], base_lobe},
            glm::vec4{surface.albedo[0], surface.albedo[1], surface.albedo[2], 0.0}};
}

}  // namespace lacquer
