#include "bake/dielectric.h"

#include <cmath>

#include "bake/half_space.h"

namespace lacquer::bake {

namespace {

// A path that carries less is ended by chance (Russian roulette), keeping the mean.
constexpr double kFaint = 0.05;
constexpr int kMaxOrder = 512;
constexpr double kDeepest = -34.0;  // log u: keeps 1 - u below 1
// Exactly along the plane a ray meets nothing but the outermost tips, and divides by 0.
constexpr double kGrazing = 1e-6;

// A ray below the top of a half space. `below` tells which side of the interface the half space
// belongs to.
struct Ray {
    Vec3 w;
    double log_u = 0.0;
    double light = 1.0;
    bool below = false;
};

// Light that leaves a half space: to which side, how steeply, how much, after how many facets.
struct Escape {
    bool below;
    double cosine, light;
    int order;
};

Ray reflect(const Ray& ray, const Vec3& wm, double reflectance) {
    return {mirror(ray.w, wm), ray.log_u, ray.light * reflectance, ray.below};
}

// The half space is turned over, so that the ray is above its facets again.
Ray refract(const Ray& ray, const Vec3& wm, double cos_theta_i, double eta,
            const FresnelSplit& split) {
    if (split.reflectance >= 1.0) return {ray.w, ray.log_u, 0.0, !ray.below};
    const Vec3 turned = -(ray.w / eta + wm * (cos_theta_i / eta - split.cos_theta_t));
    const double log_u = std::max(std::log1p(-std::exp(ray.log_u)), kDeepest);
    return {turned, log_u, ray.light * (1.0 - split.reflectance), !ray.below};
}

// Takes the light that leaves the half space off the ray and scores it.
template <typename Score>
void let_escape(Ray& ray, double lambda, int order, const Score& score) {
    if (ray.w.z <= 0.0 || ray.light <= 0.0) return;
    const double escaping = std::exp(lambda * ray.log_u);
    score(Escape{ray.below, ray.w.z, ray.light * escaping, order});
    ray.light *= 1.0 - escaping;
}

// Flies a ray that does not escape to its next facet.
void fly(Ray& ray, double lambda, double number) {
    const double meeting = ray.w.z <= 0.0 ? 1.0 : 1.0 - std::exp(lambda * ray.log_u);
    ray.log_u -= std::log1p(-number * meeting) / lambda;
    ray.log_u = std::clamp(ray.log_u, kDeepest, 0.0);
}

bool survives(Ray& ray, WalkNumbers& numbers) {
    if (ray.light >= kFaint) return true;
    if (numbers.hashed() * kFaint >= ray.light) return false;
    ray.light = kFaint;
    return true;
}

// `score(escape)` is told what leaves.
template <typename Score>
void walk(const Vec3& start, double alpha, double eta, WalkNumbers& numbers, const Score& score) {
    Ray ray{start, 0.0, 1.0, false};
    fly(ray, ggx_lambda(alpha, ray.w), numbers.next());
    // The first facet's normal: half of the circle, the plane of incidence mirrors the other half.
    double phi_number = 0.5 * numbers.next();
    for (int order = 1; order <= kMaxOrder; ++order) {
        const Vec3 wm = visible_normal(alpha, -ray.w, phi_number, numbers.next());
        const double cos_theta_i = std::min(-glm::dot(ray.w, wm), 1.0);
        const double facet_eta = ray.below ? 1.0 / eta : eta;
        const FresnelSplit split = dielectric_split(cos_theta_i, facet_eta);
        Ray reflected = reflect(ray, wm, split.reflectance);
        Ray refracted = refract(ray, wm, cos_theta_i, facet_eta, split);
        const double reflected_lambda = ggx_lambda(alpha, reflected.w);
        const double refracted_lambda = ggx_lambda(alpha, refracted.w);
        let_escape(reflected, reflected_lambda, order, score);
        let_escape(refracted, refracted_lambda, order, score);
        const double light = reflected.light + refracted.light;
        if (light <= 0.0) return;
        const bool reflects = numbers.next() * light < reflected.light;
        ray = reflects ? reflected : refracted;
        ray.light = light;
        if (!survives(ray, numbers)) return;
        fly(ray, reflects ? reflected_lambda : refracted_lambda, numbers.next());
        phi_number = numbers.next();
    }
}

// A flat facet: `score` as above.
template <typename Score>
void cross_smooth(double cosine, double eta, const Score& score) {
    const FresnelSplit split = dielectric_split(cosine, eta);
    score(Escape{false, cosine, split.reflectance, 1});
    score(Escape{true, split.cos_theta_t, 1.0 - split.reflectance, 1});
}

template <typename Score>
void cross(double cosine, double alpha, double eta, WalkNumbers& numbers, const Score& score) {
    if (alpha <= 0.0) return cross_smooth(cosine, eta, score);
    walk(Vec3{-std::sqrt(1.0 - cosine * cosine), 0.0, -cosine}, alpha, eta, numbers, score);
}

}  // namespace

void CosineHistogram::add(double cosine, double amount) {
    constexpr double kSteps = kNodes - 1;
    const auto low = std::min(static_cast<std::size_t>(kSteps * std::sqrt(cosine)), kNodes - 2);
    const auto first = static_cast<double>(low);
    const double share = (cosine * kSteps * kSteps - first * first) / (2.0 * first + 1.0);
    light[low] += amount * (1.0 - share);
    light[low + 1] += amount * share;
}

double CosineHistogram::cosine(std::size_t node) {
    const double b = static_cast<double>(node) / (kNodes - 1);
    return b * b;
}

double CosineHistogram::transmitted(double tau, double times) const {
    double sum = tau >= 1.0 ? light[0] : 0.0;
    for (std::size_t node = 1; node < kNodes; ++node)
        if (light[node] > 0.0) sum += light[node] * std::pow(tau, times / cosine(node));
    return sum;
}

void CosineHistogram::scale(double factor) {
    for (double& each : light) each *= factor;
}

CosineHistogram light_entering(double cos_theta, double alpha, double eta,
                               const SobolPoints& points, std::uint64_t node_seed) {
    const double cosine = std::clamp(cos_theta, kGrazing, 1.0);
    const std::size_t walks = alpha > 0.0 ? points.count() : 1;
    CosineHistogram entered;
    for (std::size_t n = 0; n < walks; ++n) {
        WalkNumbers numbers{points, node_seed, n};
        cross(cosine, alpha, eta, numbers, [&](const Escape& escape) {
            if (escape.below) entered.add(escape.cosine, escape.light);
        });
    }
    entered.scale(1.0 / static_cast<double>(walks));
    return entered;
}

double light_reflected_again(double cos_theta, double alpha, double eta, const SobolPoints& points,
                             std::uint64_t node_seed) {
    if (alpha <= 0.0) return 0.0;
    double reflected = 0.0;
    for (std::size_t n = 0; n < points.count(); ++n) {
        WalkNumbers numbers{points, node_seed, n};
        cross(std::clamp(cos_theta, kGrazing, 1.0), alpha, eta, numbers, [&](const Escape& escape) {
            if (!escape.below && escape.order > 1) reflected += escape.light;
        });
    }
    return reflected / static_cast<double>(points.count());
}

DiffuseExits light_leaving(double alpha, double eta, const SobolPoints& points,
                           std::uint64_t node_seed) {
    DiffuseExits exits;
    for (std::size_t n = 0; n < points.count(); ++n) {
        WalkNumbers numbers{points, node_seed, n};
        const double cosine = std::sqrt(numbers.next());
        // Turned over, the light comes from above and the index is inverted.
        cross(cosine, alpha, 1.0 / eta, numbers, [&](const Escape& escape) {
            if (escape.below)
                exits.left.add(cosine, escape.light);
            else if (escape.cosine > 0.0)
                exits.reflected.add(2.0 / (1.0 / cosine + 1.0 / escape.cosine), escape.light);
        });
    }
    const double share = 1.0 / static_cast<double>(points.count());
    exits.left.scale(share);
    exits.reflected.scale(share);
    return exits;
}

}  // namespace lacquer::bake
