// Walks of the simulator on one core: items per second are crossings of one rough dielectric
// interface, from one direction or from diffuse light.
#include <benchmark/benchmark.h>

#include <cmath>

#include "simulator/microsurface.h"

namespace lacquer::simulator {
namespace {

SurfaceWalk glass(Ndf ndf, double eta, double alpha) {
    return SurfaceWalk{
        Surface{Blend::Operator::asymmetric, {{1.0, {ndf, alpha, alpha}, DielectricFacet{eta}}}}};
}

// Alpha in hundredths.
void cross_from_air(benchmark::State& state, Ndf ndf) {
    const SurfaceWalk surface = glass(ndf, 1.5, static_cast<double>(state.range(0)) / 100.0);
    const Vec3 downwards{-std::sqrt(0.75), 0.0, -0.5};
    std::uint64_t walk = 0;
    for (auto _ : state) {
        RandomStream random{1, walk++};
        benchmark::DoNotOptimize(surface.cross(downwards, random));
    }
    state.SetItemsProcessed(state.iterations());
}
BENCHMARK_CAPTURE(cross_from_air, ggx, Ndf::ggx)->Arg(0)->Arg(10)->Arg(50)->Arg(100);
BENCHMARK_CAPTURE(cross_from_air, beckmann, Ndf::beckmann)->Arg(10)->Arg(50)->Arg(100);

void cross_from_glass(benchmark::State& state) {
    const SurfaceWalk surface = glass(Ndf::ggx, 1.5, static_cast<double>(state.range(0)) / 100.0);
    std::uint64_t walk = 0;
    for (auto _ : state) {
        RandomStream random{1, walk++};
        const Vec3 upwards = sample_cosine(random);
        benchmark::DoNotOptimize(surface.cross(upwards, random));
    }
    state.SetItemsProcessed(state.iterations());
}
BENCHMARK(cross_from_glass)->Arg(10)->Arg(50)->Arg(100);

}  // namespace
}  // namespace lacquer::simulator
