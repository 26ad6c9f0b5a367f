// Cost of one operation of each model on one core, in nanoseconds; `reference` beside it.
#include <benchmark/benchmark.h>

#include <cmath>
#include <glm/common.hpp>
#include <random>
#include <vector>

#include "lacquer/bsdf.h"
#include "reference/plain.h"

namespace lacquer {
namespace {

Material glazed() {
    Material material;
    material.layers.push_back({{1.5, Microsurface{Ndf::ggx, {0.2, 0.2}}}, {}});
    material.base = LambertianBase{{0.8, 0.7, 0.6}};
    return material;
}

// Enough directions that they do not stay in registers, few enough that they stay in the cache.
template <typename Real>
std::vector<glm::vec<3, Real>> random_directions() {
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    std::vector<glm::vec<3, Real>> directions(1024);
    for (auto& w : directions) {
        const double z = uniform(generator);
        const double phi = 6.283185307 * uniform(generator);
        const double radius = std::sqrt(1.0 - z * z);
        w = {static_cast<Real>(radius * std::cos(phi)), static_cast<Real>(radius * std::sin(phi)),
             static_cast<Real>(z)};
    }
    return directions;
}

template <typename Real>
void plain_eval(benchmark::State& state) {
    const Bsdf<Real> bsdf = prepare<Real>(glazed());
    const auto directions = random_directions<Real>();
    std::size_t i = 0;
    for (auto _ : state) {
        const auto& wi = directions[i % 1024];
        const auto& wo = directions[(7 * i + 3) % 1024];
        benchmark::DoNotOptimize(bsdf.eval(wi, wo));
        ++i;
    }
}
BENCHMARK(plain_eval<float>);
BENCHMARK(plain_eval<double>);

template <typename Real>
void plain_sample(benchmark::State& state) {
    const Bsdf<Real> bsdf = prepare<Real>(glazed());
    const auto directions = random_directions<Real>();
    std::size_t i = 0;
    for (auto _ : state) {
        const auto& u = directions[i % 1024];
        const auto& wo = directions[(7 * i + 3) % 1024];
        benchmark::DoNotOptimize(bsdf.sample(wo, glm::abs(u)));
        ++i;
    }
}
BENCHMARK(plain_sample<float>);
BENCHMARK(plain_sample<double>);

void plain_eval_reference(benchmark::State& state) {
    const reference::PlainSurface surface = reference::prepare_plain(glazed());
    const auto directions = random_directions<double>();
    std::size_t i = 0;
    for (auto _ : state) {
        const auto& wi = directions[i % 1024];
        const auto& wo = directions[(7 * i + 3) % 1024];
        benchmark::DoNotOptimize(reference::eval(surface, wi, wo));
        ++i;
    }
}
BENCHMARK(plain_eval_reference);

}  // namespace
}  // namespace lacquer
