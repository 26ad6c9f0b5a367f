#include "stack_random.h"

#include <fmt/format.h>

#include <cmath>

namespace lacquer::test {

namespace {

std::string describe(const Medium& medium, std::size_t channel) {
    if (const auto* absorbing = std::get_if<AbsorbingMedium>(&medium))
        return fmt::format("tau {:.2f}", absorbing->tau[channel]);
    const auto& slab = std::get<ScatteringMedium>(medium);
    return fmt::format("sigma_a {:.2f} sigma_s {:.2f} g {:.2f}", slab.sigma_a[channel],
                       slab.sigma_s[channel], slab.g);
}

std::string describe(const Roughness& roughness) {
    if (const auto* uniform = std::get_if<Microsurface>(&roughness))
        return fmt::format("alpha {:.2f}", uniform->alpha[0]);
    const Blend& blend = std::get<Blend>(roughness);
    std::string text = blend.op == Blend::Operator::symmetric ? "mixed" : "strata";
    for (const Stratum& stratum : blend.strata)
        text +=
            fmt::format(" {:.2f} of alpha {:.2f}", stratum.weight, stratum.microsurface.alpha[0]);
    return text;
}

}  // namespace

double uniform(std::mt19937_64& generator, double low, double high) {
    return std::uniform_real_distribution<double>{low, high}(generator);
}

Rgb uniform_rgb(std::mt19937_64& generator, double low, double high) {
    Rgb rgb;
    for (double& channel : rgb) channel = uniform(generator, low, high);
    return rgb;
}

Microsurface isotropic(double alpha) {
    return {Ndf::ggx, {alpha, alpha}};
}

// tau from 0.3, indices of varnishes, glasses and glazes in any order.
Configuration random_configuration(std::mt19937_64& generator, BaseKind base, int coats,
                                   double max_alpha) {
    Configuration at;
    for (int n = 0; n < coats; ++n) {
        const double ior = uniform(generator, 1.0, 2.2);
        const Microsurface microsurface = isotropic(uniform(generator, 0.0, max_alpha));
        const Rgb tau = uniform_rgb(generator, 0.3, 1.0);
        at.material.layers.push_back({{ior, microsurface}, AbsorbingMedium{tau}});
    }
    if (base == BaseKind::lambertian) {
        at.material.base = LambertianBase{uniform_rgb(generator, 0.0, 1.0)};
    } else if (base == BaseKind::conductor) {
        const Microsurface microsurface = isotropic(uniform(generator, 0.0, max_alpha));
        const Rgb eta = uniform_rgb(generator, 0.1, 3.0);
        at.material.base = ConductorBase{eta, uniform_rgb(generator, 0.5, 8.0), microsurface};
    } else {
        at.material.base = NoBase{};
    }
    at.cos_theta = uniform(generator, 0.05, 1.0);
    return at;
}

glm::dvec3 direction(double cos_theta) {
    return {std::sqrt(1.0 - cos_theta * cos_theta), 0.0, cos_theta};
}

void make_blended(std::mt19937_64& generator, Configuration& at, double max_alpha) {
    const auto blend = [&] {
        Blend strata;
        strata.op = uniform(generator, 0.0, 1.0) < 0.3 ? Blend::Operator::symmetric
                                                       : Blend::Operator::asymmetric;
        const int count = uniform(generator, 0.0, 1.0) < 0.7 ? 2 : 3;
        double sum = 0.0;
        for (int k = 0; k < count; ++k) {
            const double weight = uniform(generator, 0.1, 1.0);
            sum += weight;
            strata.strata.push_back(
                {weight, isotropic(uniform(generator, 0.0, max_alpha)), {}, {}, {}});
        }
        for (Stratum& stratum : strata.strata) stratum.weight /= sum;
        return strata;
    };
    for (Layer& layer : at.material.layers) layer.interface.roughness = blend();
    auto* conductor = std::get_if<ConductorBase>(&at.material.base);
    if (!conductor) return;
    Blend strata = blend();
    if (uniform(generator, 0.0, 1.0) < 0.5)
        for (Stratum& stratum : strata.strata) {
            stratum.eta = uniform_rgb(generator, 0.1, 3.0);
            stratum.kappa = uniform_rgb(generator, 0.5, 8.0);
        }
    conductor->roughness = strata;
}

std::string describe(const Configuration& at, std::size_t channel) {
    std::string text = fmt::format("cos {:.2f}", at.cos_theta);
    for (const Layer& layer : at.material.layers)
        text += fmt::format(", [ior {:.2f} {} {}]", layer.interface.ior,
                            describe(layer.interface.roughness), describe(layer.medium, channel));
    if (const auto* lambertian = std::get_if<LambertianBase>(&at.material.base))
        return text + fmt::format(", albedo {:.2f}", lambertian->albedo[channel]);
    if (std::holds_alternative<NoBase>(at.material.base)) return text;
    const auto& base = std::get<ConductorBase>(at.material.base);
    return text + fmt::format(", conductor {:.2f} + {:.2f} i {}", base.eta[channel],
                              base.kappa[channel], describe(base.roughness));
}

}  // namespace lacquer::test
