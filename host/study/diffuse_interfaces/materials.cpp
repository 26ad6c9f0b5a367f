#include "study/diffuse_interfaces/materials.h"

#include <fmt/format.h>

namespace lacquer::study {

Material coated(double eta, double alpha, const Rgb& albedo, const Rgb& tau) {
    Material material;
    material.name = fmt::format("eta {:g}, alpha {:g}", eta, alpha);
    if (tau != kClear) material.name += fmt::format(", tau {:g} {:g} {:g}", tau[0], tau[1], tau[2]);
    material.layers.push_back(
        {{eta, Microsurface{Ndf::ggx, {alpha, alpha}}}, AbsorbingMedium{tau}});
    material.base = LambertianBase{albedo};
    return material;
}

}  // namespace lacquer::study
