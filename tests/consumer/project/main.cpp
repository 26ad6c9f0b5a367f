// Uses the installed library in float and double: bundled gold against a closed form, and a white
// base under a clear coat, which the coated models must give all light back from.
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

// At normal incidence D = 1 / (pi alpha_x alpha_y) and G2 = 1: f = F / (4 pi alpha_x alpha_y).
template <typename Real>
bool is_gold_right(const char* name, const lacquer::Material& material) {
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

// What the tables are worth: see the README.
constexpr double kFurnace = 0.003;

template <typename Real>
bool is_white(const char* name, const lacquer::Material& material, lacquer::Model model) {
    const auto bsdf = lacquer::prepare<Real>(material, model);
    bool white = true;
    for (const Real cosine : {Real(0.05), Real(0.5), Real(1)}) {
        const lacquer::Vec3<Real> wo{std::sqrt((1 - cosine) * (1 + cosine)), 0, cosine};
        const auto albedo = bsdf.albedo(wo);
        const double sum = double(albedo.direct.x + albedo.base.x);
        std::printf("%-6s model %d, cosine %g: returns %.6f of light\n", name, int(model),
                    double(cosine), sum);
        white = white && std::abs(sum - 1) <= kFurnace;
    }
    return white;
}

constexpr const char* kWhite = R"({
    "layers": [{ "interface": { "ior": 1.5, "alpha": 0.3 } }],
    "base": { "lambertian": { "albedo": [1, 1, 1] } } })";

}  // namespace

int main() {
    const auto gold = lacquer::load_material(std::filesystem::path{MATERIALS} / "gold.json");
    bool right = is_gold_right<float>("float", gold);
    right = is_gold_right<double>("double", gold) && right;
    const auto white = lacquer::parse_material(kWhite, "white");
    for (const auto model : {lacquer::Model::coated_ggx, lacquer::Model::coated_exact}) {
        right = is_white<float>("float", white, model) && right;
        right = is_white<double>("double", white, model) && right;
    }
    try {
        lacquer::load_material("absent.json");
        return 1;
    } catch (const lacquer::Error& error) {
        std::printf("%s\n", error.what());
    }
    return right ? 0 : 1;
}
