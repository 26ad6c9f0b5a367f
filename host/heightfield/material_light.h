// A material's rough surface lit from several directions: as ray traced heightfields, and by
// Smith's theory.
#pragma once

#include <vector>

#include "heightfield/rough_surface.h"
#include "heightfield/scattered_light.h"

namespace lacquer::heightfield {

struct MaterialLight {
    Material material;
    RoughSurface surface;
    FieldGrid grid;
    LightOptions options;
    std::vector<double> thetas;                  // of wi to the normal, towards +x; radians
    std::vector<ScatteredLight> traced, walked;  // of each theta
};

// Steeper towards the horizon than this, rays would pass too many copies of a surface.
inline constexpr double kMaxTheta = 1.57;

// Thetas in [0, kMaxTheta]. Throws Error for a material that no heightfield stands for, see
// rough_surface.h, and for a grid out of range.
MaterialLight measure_material(const Material& material, const std::vector<double>& thetas,
                               const FieldGrid& grid, const LightOptions& options);

// Towards light at `theta` from the normal.
simulator::Vec3 direction_of(double theta);

}  // namespace lacquer::heightfield
