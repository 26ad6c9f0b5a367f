// Shades bundled gold in float and double, and checks both against the closed form at normal
// incidence: D = 1 / (pi alpha_x alpha_y), G2 = 1, so that f = F / (4 pi alpha_x alpha_y).
#include <lacquer/lacquer.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <numbers>

namespace {

// Fresnel reflectance of a conductor in air at normal incidence.
double reflectance(double eta, double kappa) {
    return ((eta - 1) * (eta - 1) + kappa * kappa) / ((eta + 1) * (eta + 1) + kappa * kappa);
}

// The relative error a few dozen roundings of `Real` may add up to.
template <typename Real>
constexpr double kTolerance = 32 * std::numeric_limits<Real>::epsilon();

template <typename Real>
bool is_right(const char* name, const lacquer::Material& material) {
    const auto& gold = std::get<lacquer::ConductorBase>(material.base);
    const auto& alpha = std::get<lacquer::Microsurface>(gold.roughness).alpha;
    const lacquer::Bsdf<Real> bsdf = lacquer::prepare<Real>(material);
    const lacquer::Vec3<Real> normal{0, 0, 1};
    const lacquer::Vec3<Real> f = bsdf.eval(normal, normal);
    bool right = true;
    for (int i = 0; i < 3; ++i) {
        const double expected =
            reflectance(gold.eta[i], gold.kappa[i]) / (4 * std::numbers::pi * alpha[0] * alpha[1]);
        std::printf("%-6s channel %d: %.9g, expected %.9g\n", name, i, double(f[i]), expected);
        right = right && std::abs(double(f[i]) - expected) <= kTolerance<Real> * expected;
    }
    return right;
}

}  // namespace

int main() {
    const auto material = lacquer::load_material(std::filesystem::path{MATERIALS} / "gold.json");
    const bool float_right = is_right<float>("float", material);
    const bool double_right = is_right<double>("double", material);
    try {
        lacquer::load_material("absent.json");
        return 1;
    } catch (const lacquer::Error& error) {
        std::printf("%s\n", error.what());
    }
    return float_right && double_right ? 0 : 1;
}
