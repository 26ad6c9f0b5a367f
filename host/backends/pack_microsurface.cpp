#include "backends/pack_microsurface.h"

#include "backends/pack_row.h"
#include "material/numbers.h"
#include "shading/microsurface_parameters.h"

namespace lacquer {

std::array<glm::vec4, kMicrosurfaceRows> pack_microsurface(const Material& material, Model model) {
    const MicrosurfaceParameters surface =
        microsurface_parameters(as_shaders_read(material), model);
    std::array<glm::vec4, kMicrosurfaceRows> rows{};
    rows[0] = {surface.op == Blend::Operator::symmetric ? 1.0 : 0.0,  // LQ_BLEND_*
               surface.strata.size(), surface.eta, 0.0};
    rows[1] = colour_row(surface.optical_depth);
    for (std::size_t k = 0; k < surface.strata.size(); ++k) {
        const MicrosurfaceParameters::Stratum& stratum = surface.strata[k];
        rows[2 + 3 * k] = facets_row(stratum.microsurface, stratum.weight);
        rows[3 + 3 * k] = colour_row(stratum.eta);
        rows[4 + 3 * k] = colour_row(stratum.kappa);
    }
    return rows;
}

std::array<glm::vec4, kSeveralFacetsRows> pack_several_facets(const Material& material,
                                                              Model model) {
    return several_facets_rows(microsurface_parameters(as_shaders_read(material), model));
}

}  // namespace lacquer
