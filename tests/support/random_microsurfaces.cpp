#include "support/random_microsurfaces.h"

#include <fmt/format.h>

#include <cmath>

namespace lacquer::test {

namespace {

double uniform(std::mt19937_64& generator, double low, double high) {
    return std::uniform_real_distribution<double>{low, high}(generator);
}

Microsurface random_microsurface(std::mt19937_64& generator, double least_alpha) {
    const auto alpha = [&] { return uniform(generator, least_alpha, 1.0); };
    const Ndf ndf = uniform(generator, 0.0, 1.0) < 0.5 ? Ndf::ggx : Ndf::beckmann;
    const double along = alpha();
    return {ndf, {along, uniform(generator, 0.0, 1.0) < 0.3 ? alpha() : along}};
}

Rgb random_rgb(std::mt19937_64& generator, double low, double high) {
    return {uniform(generator, low, high), uniform(generator, low, high),
            uniform(generator, low, high)};
}

std::string describe(const Microsurface& microsurface) {
    return fmt::format("{} {:.3f} {:.3f}", microsurface.ndf == Ndf::ggx ? "ggx" : "beckmann",
                       microsurface.alpha[0], microsurface.alpha[1]);
}

std::string describe(const Roughness& roughness) {
    if (const auto* microsurface = std::get_if<Microsurface>(&roughness))
        return describe(*microsurface);
    const Blend& blend = std::get<Blend>(roughness);
    std::string text = blend.op == Blend::Operator::symmetric ? "symmetric" : "asymmetric";
    for (const Stratum& stratum : blend.strata)
        text += fmt::format(" [{:.3f} of {}{}]", stratum.weight, describe(stratum.microsurface),
                            stratum.eta ? fmt::format(", index {:.2f} + {:.2f} i",
                                                      (*stratum.eta)[0], (*stratum.kappa)[0])
                                        : "");
    return text;
}

}  // namespace

Roughness random_roughness(std::mt19937_64& generator, int count, double least_alpha) {
    if (count == 1) return random_microsurface(generator, least_alpha);
    Blend blend;
    blend.op = uniform(generator, 0.0, 1.0) < 0.3 ? Blend::Operator::symmetric
                                                  : Blend::Operator::asymmetric;
    double sum = 0.0;
    for (int k = 0; k < count; ++k) {
        const double weight = uniform(generator, 0.05, 1.0);
        sum += weight;
        blend.strata.push_back({weight, random_microsurface(generator, least_alpha), {}, {}, {}});
    }
    for (Stratum& stratum : blend.strata) stratum.weight /= sum;
    return blend;
}

Material random_conductor(std::mt19937_64& generator, int strata, double least_alpha) {
    const auto eta = [&] { return random_rgb(generator, 0.1, 3.0); };
    const auto kappa = [&] { return random_rgb(generator, 0.5, 8.0); };
    ConductorBase base{eta(), kappa(), random_roughness(generator, strata, least_alpha)};
    if (auto* blend = std::get_if<Blend>(&base.roughness);
        blend != nullptr && uniform(generator, 0.0, 1.0) < 0.5)
        for (Stratum& stratum : blend->strata) {
            stratum.eta = eta();
            stratum.kappa = kappa();
        }
    return {"conductor", 1.0, {}, base, {}};
}

Material random_dielectric(std::mt19937_64& generator, int strata, double least_alpha) {
    const double ior = uniform(generator, 0.0, 1.0) < 0.3 ? uniform(generator, 0.5, 0.97)
                                                          : uniform(generator, 1.03, 2.2);
    return {"dielectric",
            1.0,
            {{{ior, random_roughness(generator, strata, least_alpha)}, {}}},
            NoBase{},
            {}};
}

Material mirrors(const Material& material) {
    const Roughness roughness = material.layers.empty()
                                    ? std::get<ConductorBase>(material.base).roughness
                                    : material.layers.front().interface.roughness;
    const Rgb none{0, 0, 0}, high{1e9, 1e9, 1e9};  // absorbs 1e-9
    return {"mirrors", 1.0, {}, ConductorBase{none, high, roughness}, {}};
}

std::string describe(const Material& material) {
    if (material.layers.empty()) {
        const auto& base = std::get<ConductorBase>(material.base);
        return fmt::format("conductor {:.2f} + {:.2f} i, {}", base.eta[0], base.kappa[0],
                           describe(base.roughness));
    }
    const Interface& interface = material.layers.front().interface;
    return fmt::format("dielectric {:.3f}, {}", interface.ior, describe(interface.roughness));
}

}  // namespace lacquer::test
