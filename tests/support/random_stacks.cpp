#include "support/random_stacks.h"

#include <cmath>

namespace lacquer::test {

RandomStacks::RandomStacks(const Range& range) : range_{range}, random_{range.seed} {}

double RandomStacks::uniform(double low, double high) {
    return std::uniform_real_distribution<double>{low, high}(random_);
}

glm::dvec3 RandomStacks::numbers() {
    return {uniform(0, 1), uniform(0, 1), uniform(0, 1)};
}

Material RandomStacks::next() {
    Material material;
    const int count = 1 + static_cast<int>(uniform(0.0, 4.0));
    for (int n = 0; n < count; ++n) {
        Layer layer{{uniform(0.8, 2.2), roughness()}, AbsorbingMedium{rgb(0.3, 1.0)}};
        if (uniform(0.0, 3.0) < 1.0)
            layer.medium =
                ScatteringMedium{rgb(0.0, 0.5), rgb(0.0, 3.0), uniform(range_.least_g, 0.95), 1.0};
        material.layers.push_back(layer);
    }
    const double base = uniform(0.0, 3.0);
    if (base < 1.0)
        material.base = NoBase{};
    else if (base < 2.0)
        material.base = LambertianBase{rgb(0.0, 1.0)};
    else
        material.base = ConductorBase{rgb(0.1, 3.0), rgb(0.5, 8.0), facets()};
    return material;
}

glm::dvec3 RandomStacks::direction(double least_cosine) {
    const double cosine = uniform(least_cosine, 1.0), turn = uniform(0.0, 6.28);
    const double sine = std::sqrt(1.0 - cosine * cosine);
    return {sine * std::cos(turn), sine * std::sin(turn), cosine};
}

Roughness RandomStacks::roughness() {
    if (!range_.with_blends || uniform(0.0, 2.0) < 1.0) return facets();
    Blend blend{uniform(0.0, 3.0) < 1.0 ? Blend::Operator::symmetric : Blend::Operator::asymmetric,
                {}};
    const int count = 2 + static_cast<int>(uniform(0.0, 3.0));
    for (int k = 0; k < count; ++k)
        blend.strata.push_back(
            {k + 1 < count ? uniform(0.05, 0.9) / (count - 1) : 1.0, facets(), {}, {}, {}});
    for (int k = 0; k + 1 < count; ++k)
        blend.strata.back().weight -= blend.strata[static_cast<std::size_t>(k)].weight;
    return blend;
}

Microsurface RandomStacks::facets() {
    const double kind = uniform(0.0, 4.0), alpha = kind < 1.0 ? 0.0 : uniform(0.002, 0.8);
    return {kind > 3.0 && range_.with_beckmann ? Ndf::beckmann : Ndf::ggx, {alpha, alpha}};
}

Rgb RandomStacks::rgb(double low, double high) {
    return {uniform(low, high), uniform(low, high), uniform(low, high)};
}

}  // namespace lacquer::test
