#include "reference/stack/scattering.h"

#include <algorithm>
#include <cmath>

namespace lacquer::reference {

namespace {

// The two streams lose this much light per absorption depth, and exchange this much per scattering
// depth times 1 - g. 2 and 0.75 in the Eddington approximation (Meador and Weaver, table 1).
constexpr double kStreamLoss = 2.30, kStreamExchange = 0.794;
// The share g^kForwardPower of scattered light goes on as if it had not been; 2 in Joseph et al.
constexpr double kForwardPower = 1.85;
// Less so near grazing, where a small turn already leads out of the beam.
constexpr double kGrazingForward = 0.314;
// Of the light that leaves the beam, what goes backwards.
constexpr double kUp = 0.5, kUpScattered = 0.159;
constexpr double kDown = 0.734, kDownForward = 1.13, kDownPower = 0.709;

// Closer than that to the depth of the streams, that of the beam divides 0 by 0.
constexpr double kResonance = 1e-3, kOffResonance = 6.0 * kResonance;
constexpr double kTiny = 1e-12;  // keeps quotients of nothing finite
// tanh(x) / x below this is 1 - x^2 / 3 to rounding.
constexpr double kSmallDepth = 1e-3;
constexpr double kLeastCosine = 1e-3;
// Of the lobes that alpha_of_spread was fitted to.
constexpr double kLeastLobeCosine = 0.05;

constexpr double kLambertianSpread = 0.5;
constexpr double kMostSpread = 0.62;     // which a GGX lobe can still have
constexpr double kMostScattered = 0.55;  // of scattered light in nine slabs of ten
constexpr double kLeastWidth = 1e-6;     // of which the logarithm is finite
constexpr double kMostAlpha = 0.95;

// A slab that is `depth` deep for the beam, of which `fed` of what it loses joins the streams,
// the share `up` of that going backwards.
struct TwoStreams {
    double loss, exchange;  // of the streams, across the slab
    double depth, fed, up;
};

struct StreamLight {
    double transmitted, back;
};

StreamLight solve(TwoStreams streams) {
    const double depth = streams.depth, up = streams.up, down = 1.0 - up;
    const double b = streams.exchange;
    double a = streams.loss;
    if (std::abs(depth - std::sqrt(a * (a + 2.0 * b))) < kResonance * depth)
        a *= 1.0 - kOffResonance;
    const double squared = a * (a + 2.0 * b);
    const double k = std::sqrt(squared), fade = std::exp(-k);
    const double sech = 2.0 * fade / (1.0 + fade * fade);
    const double tanh_ratio =
        k < kSmallDepth ? 1.0 - squared / 3.0 : (1.0 - fade * fade) / (1.0 + fade * fade) / k;

    const double beam = std::exp(-depth);
    const double with = a * down + b, against = a * up + b;
    const double scale =
        streams.fed * depth / ((depth * depth - squared) * (1.0 + (a + b) * tanh_ratio));
    return {beam - scale * (beam * ((depth * with + squared * down) * tanh_ratio + depth * down +
                                    with) -
                            (depth * down + with) * sech),
            scale * ((depth * against - squared * up) * tanh_ratio +
                     (depth * up - against) * (1.0 - beam * sech))};
}

TwoStreams streams_in(const ScatteringSlab& slab, double cosine) {
    const double forward = std::max(slab.g, 0.0);
    const double kept = std::pow(forward, kForwardPower);
    // The mean cosine of what is not kept.
    const double g = (slab.g - kept) / (1.0 - kept);
    const double beam_kept = kept * cosine / (cosine + kGrazingForward * forward * (1.0 - forward));
    const double leaving = slab.scattering * (1.0 - beam_kept);
    const double lost = slab.absorption + leaving;
    const double albedo = slab.scattering / std::max(slab.scattering + slab.absorption, kTiny);
    const double up = kUp + kUpScattered * albedo * forward -
                      (kDown + kDownForward * std::max(g, 0.0)) * g * std::pow(cosine, kDownPower);
    return {kStreamLoss * slab.absorption, kStreamExchange * slab.scattering * (1.0 - slab.g),
            std::max(lost / cosine, kTiny), leaving / std::max(lost, kTiny),
            std::clamp(up, 0.0, 1.0)};
}

double unscattered_share(const ScatteringSlab& slab, double cosine) {
    return std::exp(-(slab.absorption + slab.scattering) / cosine);
}

// Depth of scattering that would turn light as much if it were isotropic (similarity).
double turning_depth(const ScatteringSlab& slab) {
    return slab.scattering * (1.0 - slab.g);
}

}  // namespace

ScatteringSlab scattering_slab(const ScatteringMedium& medium, std::size_t channel) {
    return {medium.sigma_a[channel] * medium.thickness, medium.sigma_s[channel] * medium.thickness,
            medium.g};
}

SlabLight slab_light(const ScatteringSlab& slab, double cos_theta) {
    const double cosine = std::max(cos_theta, kLeastCosine);
    const double unscattered = unscattered_share(slab, cosine);
    const StreamLight light = solve(streams_in(slab, cosine));
    return {unscattered, std::max(light.transmitted - unscattered, 0.0), std::max(light.back, 0.0)};
}

// Fitted, like the lobes below, to simulated slabs: linear in thin ones, bounded in deep ones.
SlabLobe transmitted_lobe(const ScatteringSlab& slab, double cos_theta) {
    const double cosine = std::max(cos_theta, kLeastCosine);
    const double forward = std::max(slab.g, 0.0), isotropic = 1.0 - forward;
    const double path = turning_depth(slab) / cosine;
    const double most = 0.394 + 0.186 * isotropic * (1.0 - cosine);
    // Absorption takes from light that scattering leads to longer ways, and spares what it leads
    // to shorter ones.
    const double longer = 1.80 * isotropic * slab.absorption;
    const double shorter =
        (1.47 * isotropic + 0.0559 * forward) * slab.absorption * (1.0 / cosine - 1.0);
    const double rate = (1.16 * (1.0 + std::min(slab.g, 0.0)) + 1.63 * forward) *
                        std::pow(cosine, 0.197 * forward - 0.0709) * (1.0 + shorter) /
                        (1.0 + longer);
    const double turned =
        (0.613 + 0.898 * forward) * turning_depth(slab) / (cosine + 0.130 * forward);
    return {most * (1.0 - std::exp(-rate * path * (1.0 + 0.474 * path))),
            std::exp(-turned / (1.0 + 0.278 * (1.0 - cosine) * forward * turned))};
}

SlabLobe scattered_lobe(const ScatteringSlab& slab, double cos_theta, const SlabLight& light) {
    const SlabLobe all = transmitted_lobe(slab, cos_theta);
    const double share = light.scattered / std::max(light.transmitted(), kTiny);
    return {std::min(all.spread / std::max(share, kTiny), kMostScattered),
            std::max(1.0 - (1.0 - all.sine_ratio) / std::max(share, kTiny), 0.0)};
}

SlabLobe back_lobe(const ScatteringSlab& slab, double cos_theta) {
    const double forward = std::max(slab.g, 0.0);
    const double depth = turning_depth(slab);
    return {kLambertianSpread, (0.046 + 1.006 * forward) * (1.0 - 0.5 * std::sqrt(cos_theta)) /
                                   (1.0 + 1.39 * depth / (depth + 0.574))};
}

double alpha_of_spread(double spread, double cos_theta) {
    const double v = std::clamp(spread, 0.0, kMostSpread);
    const double width = std::max(std::sqrt(v), kLeastWidth);
    const double c = std::clamp(cos_theta, kLeastLobeCosine, 1.0);
    const double log_alpha = 1.0345 * std::log(width) - 0.2286 / (c + 0.1) - 1.4913 * c +
                             1.9008 * c * width + (0.4404 - 1.2914 * std::log(c)) * v * v;
    return std::min(std::exp(log_alpha), kMostAlpha);
}

SlabLight slab_light_2018(const ScatteringSlab& slab, double cos_theta) {
    const double cosine = std::max(cos_theta, kLeastCosine);
    const double unscattered = unscattered_share(slab, cosine);
    return {unscattered, slab.scattering / cosine * unscattered, 0.0};
}

double scattering_variance_2018(double g) {
    return std::pow((1.0 - g) / g, 0.8) / (1.0 + g);
}

}  // namespace lacquer::reference
