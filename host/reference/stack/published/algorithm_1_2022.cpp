#include "reference/stack/published/algorithm_1_2022.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>

#include "core/error.h"
#include "reference/fresnel.h"
#include "reference/shading.h"
#include "reference/stack/directions.h"
#include "reference/stack/published/operators_2018.h"

namespace lacquer::reference::published_2022 {

namespace {

namespace p2018 = published_2018;

constexpr double kTiny = 1e-9;  // keeps quotients of nothing finite

// What an interface reflects and lets through, with its crossings of the medium below it.
struct Coefficients {
    Energy reflected_down{0.0}, transmitted_down{0.0};  // of light going down, at its own cosine
    Energy reflected_up{0.0}, transmitted_up{0.0};
};

double refracted_cosine(double cosine, double eta) {
    const double sine = p2018::refracted_sine(direction_of(cosine).x, eta);
    return std::max(direction_of(sine).x, kLeastCosine);
}

// Of a uniform interface, as the paper has no others.
double alpha_of(const StackInterface& at) {
    return at.strata.front().alpha;
}

// What is left of the transmittance along the mean of a GGX lobe of roughness alpha. 2018, Eq. 33.
double left_of_lobe(const EnergyTables& tables, double cosine, double alpha, double eta) {
    const double along_mean = 1.0 - fresnel(cosine, eta);
    return along_mean > kTiny ? std::min(tables.tir(cosine, alpha, eta) / along_mean, 1.0) : 0.0;
}

// For light from above at `cosine`, refracted to `below`, and light from below of roughness `alpha`
// about the latter. 2018, Eqs. 34 and 35.
Coefficients coefficients(const StackLayers& layers, std::size_t n, double cosine, double below,
                          double alpha) {
    const StackInterface& at = layers.interfaces[n];
    const Energy crossing = layers.media[n].transmittance(below);
    const double down = at.entering(cosine);
    const double up = at.transmittance(at.strata.front(), below, false) *
                      left_of_lobe(*layers.tables, below, alpha, at.eta(false));
    return {Energy{1.0 - down}, down * crossing, (1.0 - up) * crossing * crossing, up * crossing};
}

Energy series(const Energy& ratio) {
    return Energy{1.0} / glm::max(Energy{1.0} - ratio, Energy{kTiny});
}

// rho_2+ of the last interface over the base. 2022, Eq. 3.
Energy coated_base(const StackLayers& layers, const glm::dvec3& albedo, double cosine) {
    const EnergyTables& tables = *layers.tables;
    const StackInterface& at = layers.interfaces.back();
    const Energy tau = glm::exp(-layers.media.back().absorption);
    const double eta = at.eta(true);
    Energy energy{0.0};
    for (int channel = 0; channel < 3; ++channel) {
        const double rho = albedo[channel], through = tau[channel];
        energy[channel] = tables.t_down(cosine, alpha_of(at), eta, through) * rho /
                          (1.0 - rho * tables.r_up(alpha_of(at), eta, through)) *
                          tables.t_up(alpha_of(at), eta, through);
    }
    return energy;
}

// sigma_2+ of an interface, in the space of f: tabled over eta and alpha alone.
double most_variance(const StackLayers& layers, const StackInterface& at) {
    const double variance = layers.tables->variance(alpha_of(at), at.eta(true), 1.0);
    return p2018::variance_of_alpha(layers.tables->equivalent_alpha(variance));
}

// The light that reaches the last interface, and what the interfaces above it reflect back down.
struct Arriving {
    Energy transmitted{1.0}, reflected_back{0.0};
    double cosine;
};

// 2018, Eqs. 30 and 31, from the top to the last interface but one.
Arriving arriving_at_last(const StackLayers& layers, double cosine) {
    Arriving all{Energy{1.0}, Energy{0.0}, cosine};
    for (std::size_t n = 0; n + 1 < layers.count(); ++n) {
        const double below = refracted_cosine(all.cosine, layers.interfaces[n].eta(true));
        const Coefficients at =
            coefficients(layers, n, all.cosine, below, alpha_of(layers.interfaces[n + 1]));
        const Energy again = series(all.reflected_back * at.reflected_down);
        all.transmitted *= at.transmitted_down * again;
        all.reflected_back =
            at.reflected_up + at.transmitted_up * all.reflected_back * at.transmitted_down * again;
        all.cosine = below;
    }
    return all;
}

// The lobe on its way up, its mean along the normal.
class Rising {
 public:
    // `coated` is rho_2+ along the normal.
    Rising(const StackLayers& layers, const Energy& energy, const Energy& coated, Below below)
        : layers_{layers},
          below_{below},
          energy_{energy},
          variance_{most_variance(layers, layers.interfaces.back())} {
        const std::size_t last = layers.count() - 1;
        reflected_ = Energy{1.0 - layers.interfaces[last].entering(1.0)};
        if (below == Below::all) reflected_ += coated;
    }

    // 2022, Eqs. 12 and 13, and the clamp of section 5.
    void cross(std::size_t n) {
        const StackInterface& at = layers_.interfaces[n];
        const double eta = at.eta(true);
        const Coefficients along_normal = coefficients(layers_, n, 1.0, 1.0, alpha());
        const Energy round_trip = along_normal.reflected_up * reflected_;
        energy_ *= along_normal.transmitted_up * series(round_trip);

        const double again = mean(glm::dvec3{round_trip * series(round_trip)});
        const double own = p2018::variance_of_alpha(alpha_of(at));
        const double next = p2018::variance_of_alpha(alpha_of(layers_.interfaces[n + 1]));
        const double scale = p2018::refraction_scale(1.0, 1.0, 1.0 / eta);
        variance_ = p2018::refracted_variance(variance_ + (own + next) * again, 1.0 / eta) +
                    p2018::variance_of_alpha(scale * alpha_of(at));
        variance_ = std::min(variance_, most_variance(layers_, at));

        Energy seen = along_normal.reflected_down;
        if (below_ == Below::all)
            seen += along_normal.transmitted_down * reflected_ * along_normal.transmitted_up *
                    series(round_trip);
        reflected_ = seen;
    }

    const Energy& energy() const { return energy_; }
    double alpha() const { return p2018::alpha_of_variance(variance_); }

 private:
    const StackLayers& layers_;
    Below below_;
    Energy energy_, reflected_;
    double variance_;
};

}  // namespace

DiffuseLobe diffuse_lobe(const StackLayers& layers, const glm::dvec3& albedo, double cosine,
                         Below below) {
    for (const StackMedium& medium : layers.media)
        if (medium.slabs) throw Error{"algorithm 1 of 2022 has no media that scatter"};
    const Arriving light = arriving_at_last(layers, cosine);
    Energy energy = light.transmitted * coated_base(layers, albedo, light.cosine);
    if (below == Below::all) {
        const StackInterface& last = layers.interfaces.back();
        energy *= series(light.reflected_back * Energy{1.0 - last.entering(light.cosine)});
    }
    Rising lobe{layers, energy, coated_base(layers, albedo, 1.0), below};
    for (std::size_t n = layers.count() - 1; n-- > 0;) lobe.cross(n);
    const double alpha = std::max(lobe.alpha(), kMinAlpha);
    return {glm::dvec3{lobe.energy()},
            {{Ndf::ggx, alpha, alpha}, layers.tables->mirror_single(1.0, alpha)}};
}

glm::dvec3 eval(const DiffuseLobe& lobe, const glm::dvec3& wi) {
    return is_above(wi) ? lobe.energy * normal_lobe(lobe.shape, wi) : glm::dvec3{0.0};
}

}  // namespace lacquer::reference::published_2022
