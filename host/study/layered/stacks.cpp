#include "study/layered/stacks.h"

#include <utility>

#include "core/error.h"
#include "material/optical_constants.h"

namespace lacquer::study {

namespace {

Microsurface isotropic(double alpha) {
    return {Ndf::ggx, {alpha, alpha}};
}

}  // namespace

Layer coat(double ior, double alpha, const Rgb& tau) {
    return {{ior, isotropic(alpha)}, AbsorbingMedium{tau}};
}

Layer scattering_film(double thickness, double g) {
    return {{1.0, isotropic(0.0)}, ScatteringMedium{Rgb{}, {1.0, 1.0, 1.0}, g, thickness}};
}

ConductorBase grey_conductor(double eta, double kappa, double alpha) {
    return {{eta, eta, eta}, {kappa, kappa, kappa}, isotropic(alpha)};
}

ConductorBase metal(std::string_view name, double alpha) {
    const OpticalConstants* constants = find_optical_constants(name);
    if (constants == nullptr) throw Error{"no metal '" + std::string{name} + "'"};
    return {constants->eta, constants->kappa, isotropic(alpha)};
}

Material stack_of(std::string name, std::vector<Layer> layers, Base base) {
    Material material;
    material.name = std::move(name);
    material.layers = std::move(layers);
    material.base = std::move(base);
    return material;
}

}  // namespace lacquer::study
