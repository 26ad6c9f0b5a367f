#include "bake/mirror.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "bake/half_space.h"

namespace lacquer::bake {

namespace {

constexpr double kFaint = 0.02;  // less light goes on by chance (Russian roulette)
constexpr int kMaxOrder = 512;
constexpr double kGrazing = 1e-6;  // along the plane a ray meets only the outermost tips

Vec3 arriving(double cos_theta) {
    const double cosine = std::clamp(cos_theta, kGrazing, 1.0);
    return {-std::sqrt(1.0 - cosine * cosine), 0.0, -cosine};
}

// Walks over mirror facets. `meet(cosine)` is told each facet's cosine; `leave(share)` the
// share of the light that leaves after it.
template <typename Meet, typename Leave>
void walk(Vec3 w, double alpha, WalkNumbers& numbers, const Meet& meet, const Leave& leave) {
    double light = 1.0;
    double log_u = std::log1p(-numbers.next()) / -ggx_lambda(alpha, w);
    double phi_number = 0.5 * numbers.next();
    for (int order = 0; order < kMaxOrder; ++order) {
        const Vec3 wm = visible_normal(alpha, -w, phi_number, numbers.next());
        meet(std::clamp(-glm::dot(w, wm), 0.0, 1.0));
        w = mirror(w, wm);
        const double lambda = ggx_lambda(alpha, w);
        double meeting = 1.0;
        if (w.z > 0.0) {
            const double escaping = std::exp(lambda * log_u);
            leave(light * escaping);
            meeting = 1.0 - escaping;
        }
        light *= meeting;
        if (light < kFaint) {
            if (numbers.hashed() * kFaint >= light) return;
            light = kFaint;
        }
        log_u = std::min(log_u - std::log1p(-numbers.next() * meeting) / lambda, 0.0);
        phi_number = numbers.next();
    }
}

}  // namespace

void FresnelCurves::attenuate(double cosine, std::span<float> weights) const {
    const double position = std::sqrt(cosine) * (kNodes - 1);
    const auto low = std::min(static_cast<std::size_t>(position), kNodes - 2);
    const auto share = static_cast<float>(position - static_cast<double>(low));
    const float* first = values_.data() + low * count_;
    const float* second = first + count_;
    for (std::size_t n = 0; n < count_; ++n)
        weights[n] *= first[n] + share * (second[n] - first[n]);
}

double conductor_reflectance(double cos_theta_i, double eta, double kappa) {
    using Complex = std::complex<double>;
    const Complex index{eta, kappa};
    if (index == Complex{} || cos_theta_i <= 0.0) return 1.0;
    const Complex sin_theta_t = std::sqrt(1.0 - cos_theta_i * cos_theta_i) / index;
    const Complex cos_theta_t = std::sqrt(1.0 - sin_theta_t * sin_theta_t);
    const Complex s = (cos_theta_i - index * cos_theta_t) / (cos_theta_i + index * cos_theta_t);
    const Complex p = (index * cos_theta_i - cos_theta_t) / (index * cos_theta_i + cos_theta_t);
    return 0.5 * (std::norm(s) + std::norm(p));
}

std::vector<double> reflected_by_facets(double cos_theta, double alpha, const FresnelCurves& curves,
                                        const SobolPoints& points, std::uint64_t node_seed) {
    std::vector<double> sums(curves.count(), 0.0);
    std::vector<float> weights(curves.count());
    if (alpha <= 0.0) {
        std::fill(weights.begin(), weights.end(), 1.0f);
        curves.attenuate(cos_theta, weights);
        return {weights.begin(), weights.end()};
    }
    for (std::size_t n = 0; n < points.count(); ++n) {
        WalkNumbers numbers{points, node_seed, n};
        std::fill(weights.begin(), weights.end(), 1.0f);
        walk(
            arriving(cos_theta), alpha, numbers,
            [&](double cosine) { curves.attenuate(cosine, weights); },
            [&](double share) {
                for (std::size_t m = 0; m < sums.size(); ++m) sums[m] += share * weights[m];
            });
    }
    for (double& sum : sums) sum /= static_cast<double>(points.count());
    return sums;
}

namespace {

// Means over the directions that leave after one facet: of 1 and of `value(cosine)`.
template <typename Value>
std::pair<double, double> first_facet_means(double cos_theta, double alpha,
                                            const SobolPoints& points, std::uint64_t node_seed,
                                            const Value& value) {
    // Averaged over heights, the chance to leave is G2 / G1.
    const Vec3 w = arriving(cos_theta);
    const double masking = 1.0 + ggx_lambda(alpha, -w);
    double energy = 0.0, sum = 0.0;
    for (std::size_t n = 0; n < points.count(); ++n) {
        WalkNumbers numbers{points, node_seed, n};
        const double phi_number = 0.5 * numbers.next();
        const Vec3 out = mirror(w, visible_normal(alpha, -w, phi_number, numbers.next()));
        if (out.z <= 0.0) continue;
        const double leaving = masking / (masking + ggx_lambda(alpha, out));
        energy += leaving;
        sum += leaving * value(std::min(out.z, 1.0));
    }
    const auto count = static_cast<double>(points.count());
    return {energy / count, sum / count};
}

}  // namespace

double reflected_once(double cos_theta, double alpha, const SobolPoints& points,
                      std::uint64_t node_seed) {
    if (alpha <= 0.0) return 1.0;
    return first_facet_means(cos_theta, alpha, points, node_seed, [](double) { return 0.0; }).first;
}

double mean_lobe_cosine(double cos_theta, double alpha, const SobolPoints& points,
                        std::uint64_t node_seed) {
    if (alpha <= 0.0) return cos_theta;
    constexpr double kDiffuse = 2.0 / 3.0;
    const auto [energy, cosine] =
        first_facet_means(cos_theta, alpha, points, node_seed, [](double c) { return c; });
    return cosine + (1.0 - energy) * kDiffuse;
}

double lobe_transmittance(double cos_theta, double alpha, double eta, const SobolPoints& points,
                          std::uint64_t node_seed) {
    const auto transmittance = [eta](double cosine) {
        return 1.0 - dielectric_split(cosine, eta).reflectance;
    };
    if (alpha <= 0.0) return transmittance(cos_theta);
    const auto [energy, transmitted] =
        first_facet_means(cos_theta, alpha, points, node_seed, transmittance);
    return energy > 0.0 ? transmitted / energy : 0.0;
}

}  // namespace lacquer::bake
