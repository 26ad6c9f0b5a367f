#include "heightfield/material_light.h"

#include <cmath>

namespace lacquer::heightfield {

simulator::Vec3 direction_of(double theta) {
    return {std::sin(theta), 0.0, std::cos(theta)};
}

MaterialLight measure_material(const Material& material, const std::vector<double>& thetas,
                               const FieldGrid& grid, const LightOptions& options) {
    MaterialLight light{material, rough_surface(material), grid, options, thetas, {}, {}};
    require_grid(grid);
    std::vector<simulator::Vec3> wi;
    for (const double theta : thetas) wi.push_back(direction_of(theta));
    light.traced = heightfield_light(light.surface.strata, wi, grid, options);
    light.walked = smith_light(light.surface.walk, wi, options);
    return light;
}

}  // namespace lacquer::heightfield
