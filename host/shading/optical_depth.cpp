#include "shading/optical_depth.h"

#include <cmath>

namespace lacquer {

Rgb optical_depth(const Medium& medium) {
    Rgb depth{};
    for (std::size_t i = 0; i < depth.size(); ++i) {
        if (const auto* absorbing = std::get_if<AbsorbingMedium>(&medium))
            depth[i] = -std::log(absorbing->tau[i]);
        else if (const auto* scattering = std::get_if<ScatteringMedium>(&medium))
            depth[i] = scattering->sigma_a[i] * scattering->thickness;
    }
    return depth;
}

Rgb relative_index(Rgb index, double exterior_ior) {
    for (double& channel : index) channel /= exterior_ior;
    return index;
}

}  // namespace lacquer
