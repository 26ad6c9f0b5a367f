// Random coated and layered materials and directions over their whole ranges, a quarter of the
// numbers at an edge: finite light, none of it negative, and no more of it than there was.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "backends/expect_light.h"

namespace lacquer::test {
namespace {

// What a white surface may return: the tables' error.
constexpr double kMostAlbedo = 1.003;

constexpr std::uint64_t kFewQueries = 1 << 16;
// SwiftShader takes minutes for as many of stacks as others take seconds for.
constexpr std::uint64_t kQueriesOnSwiftShader = 1 << 13;
constexpr std::uint64_t kManyQueries = 10'000'000;
constexpr std::uint64_t kQueriesPerMaterial = 16;
constexpr std::uint64_t kMaterialsAtOnce = 4096;

constexpr double kAlmostOne = 1.0 - 0x1p-24;
constexpr double kDenormal = 1e-40;
constexpr double kLargest = std::numeric_limits<float>::max();

class Chooser {
 public:
    explicit Chooser(std::uint64_t seed) : random_{seed} {}

    double uniform() { return std::uniform_real_distribution<double>{0.0, 1.0}(random_); }
    bool one_in(int count) { return random_() % static_cast<std::uint64_t>(count) == 0; }

    template <std::size_t N>
    double one_of(const double (&values)[N]) {
        return values[random_() % N];
    }

    // In [0, 1].
    double share() {
        return one_in(4) ? one_of({0.0, 1.0, kDenormal, 1e-30, kAlmostOne}) : uniform();
    }

    Rgb shares() { return {share(), share(), share()}; }

    double alpha() {
        return one_in(4) ? one_of({0.0, 1e-30, 1e-4, 0.00099999, 1e-3, kAlmostOne, 1.0})
                         : uniform();
    }

    double g() { return one_in(4) ? one_of({-0.99, 0.0, 0.99}) : 1.98 * uniform() - 0.99; }

    double eta() {
        if (one_in(4))
            return one_of(
                {1.0 / 3.0, 3.0, 1.0, 1.0 - 0x1p-24, 1.0 + 0x1p-23, 0.9999, 1.0001, 0.999, 1.001});
        return std::exp((2.0 * uniform() - 1.0) * std::log(3.0));
    }

    Material material() {
        const double alpha_x = alpha();
        const double alpha_y = one_in(8) ? alpha() : alpha_x;
        const Ndf ndf = one_in(4) ? Ndf::beckmann : Ndf::ggx;
        Layer coat{{eta(), Microsurface{ndf, {alpha_x, alpha_y}}}, AbsorbingMedium{shares()}};
        const Rgb albedo = shares();
        const Rgb& tau = std::get<AbsorbingMedium>(coat.medium).tau;
        std::string name =
            fmt::format("{} coat of alpha {} {}, eta {}, tau {} {} {}, albedo {} {} {}",
                        ndf == Ndf::ggx ? "GGX" : "Beckmann", alpha_x, alpha_y, coat.interface.ior,
                        tau[0], tau[1], tau[2], albedo[0], albedo[1], albedo[2]);
        return {std::move(name), 1.0, {coat}, LambertianBase{albedo}, {}};
    }

    // One to eight layers over any base that `stack` shades.
    Material stack() {
        Material material = this->material();
        material.name = "stack with a " + material.name;
        const int more = one_in(4) ? 7 : static_cast<int>(3.0 * uniform());
        for (int n = 0; n < more; ++n) {
            const double ratio = eta(), above = material.layers.back().interface.ior;
            const double ior = std::clamp(above * ratio, 1.0, 3.0);
            material.layers.push_back({{std::clamp(ior, above / 3.0, above * 3.0),
                                        Microsurface{Ndf::ggx, {alpha(), alpha()}}},
                                       AbsorbingMedium{shares()}});
            if (one_in(4))
                material.layers.back().medium = ScatteringMedium{
                    shares(), {5.0 * share(), 5.0 * share(), 5.0 * share()}, g(), 1.0};
            material.name += fmt::format(", index {} below", ior);
        }
        if (one_in(4)) material.base = NoBase{};
        if (one_in(2))
            material.base = ConductorBase{shares(),
                                          {5.0 * share(), 5.0 * share(), 5.0 * share()},
                                          Microsurface{Ndf::ggx, {alpha(), alpha()}}};
        return material;
    }

    // Unit, above the surface or an eighth below it; grazing, along the normal and at the critical
    // angle of `eta` too.
    glm::vec4 unit_direction(double eta) {
        double cos_theta = uniform();
        if (one_in(4)) {
            const double critical = std::sqrt(std::max(1.0 - eta * eta, 0.0));
            cos_theta = one_of({0.0, kDenormal, 1e-30, 1e-8, 1e-4, kAlmostOne, 1.0, critical,
                                critical + 1e-7, std::max(critical - 1e-7, 0.0)});
        }
        if (one_in(8)) cos_theta = -cos_theta;
        const double sin_theta = std::sqrt(std::max(1.0 - cos_theta * cos_theta, 0.0));
        const double phi = 6.283185307179586 * uniform();
        return {sin_theta * std::cos(phi), sin_theta * std::sin(phi), cos_theta, 0.0};
    }

    // No direction at all: vectors of any finite length, 0 and the largest included.
    glm::vec4 strange_direction() {
        const auto number = [&] {
            return one_of({0.0, kDenormal, 1e-20, 0.3, 1.0, 3.0, 1e10, 1e19, 1e38, kLargest}) *
                   (one_in(2) ? 1.0 : -1.0);
        };
        return {number(), number(), number(), 0.0};
    }

    glm::vec4 direction(double eta) {
        return one_in(16) ? strange_direction() : unit_direction(eta);
    }

    // A viewer for a light at `wi`: often the light's own direction, or where a mirror sends it.
    glm::vec4 viewer(const glm::vec4& wi, double eta) {
        if (one_in(16)) return wi;
        if (one_in(16)) return {-wi.x, -wi.y, wi.z, 0.0};
        return direction(eta);
    }

    glm::vec4 numbers() {
        const auto number = [&] {
            return one_in(8) ? one_of({0.0, kDenormal, kAlmostOne}) : uniform() * kAlmostOne;
        };
        return {number(), number(), number(), 0.0};
    }

 private:
    std::mt19937_64 random_;
};

bool is_stack(Model model) {
    return model == Model::stack || model == Model::stack_symmetric;
}

// The same materials and viewers for every kernel.
struct Jobs {
    OwnedJob eval, sample, albedo, lights;
};

Jobs random_jobs(Chooser& chooser, Model model, std::uint64_t material_count) {
    Jobs jobs{{Kernel::eval, {}, kQueriesPerMaterial, {}, {}, model},
              {Kernel::sample, {}, kQueriesPerMaterial, {}, {}, model},
              {Kernel::albedo, {}, kQueriesPerMaterial, {}, {}, model},
              {Kernel::lights, {}, kQueriesPerMaterial, {}, {}, model}};
    jobs.lights.parameters.point_count = 1;
    for (std::uint64_t n = 0; n < material_count; ++n) {
        jobs.eval.materials.push_back(is_stack(model) ? chooser.stack() : chooser.material());
        const double eta = jobs.eval.materials.back().layers[0].interface.ior;
        for (std::uint64_t query = 0; query < kQueriesPerMaterial; ++query) {
            const glm::vec4 wi = chooser.direction(eta);
            const glm::vec4 wo = chooser.viewer(wi, eta);
            jobs.eval.inputs.insert(jobs.eval.inputs.end(), {wi, wo});
            jobs.sample.inputs.insert(jobs.sample.inputs.end(), {wo, chooser.numbers()});
            jobs.albedo.inputs.push_back(wo);
            jobs.lights.inputs.push_back(query % 2 == 0 ? wi : wo);  // a light, then its viewer
        }
    }
    jobs.sample.materials = jobs.albedo.materials = jobs.lights.materials = jobs.eval.materials;
    return jobs;
}

// The largest directional albedo; more than kMostAlbedo is a failure.
double largest_albedo(const OwnedJob& owned, const JobResult& result) {
    double largest = 0.0;
    std::size_t where = 0;
    for (std::size_t query = 0; 3 * query < result.rows.size(); ++query)
        for (int c = 0; c < 3; ++c) {
            const double albedo = result.rows[3 * query][c] + result.rows[3 * query + 1][c] +
                                  result.rows[3 * query + 2][c];
            if (albedo <= largest) continue;
            largest = albedo;
            where = query;
        }
    EXPECT_LE(largest, kMostAlbedo) << describe(owned, where);
    return largest;
}

void expect_sense_of_random_queries(const std::string& backend_name, Model model,
                                    std::uint64_t query_count) {
    std::string skipped;
    const auto backend = create_or_explain(backend_name, skipped);
    if (!backend) GTEST_SKIP() << skipped;
    Chooser chooser{1};
    double albedo = 0.0;
    std::uint64_t left = query_count / kQueriesPerMaterial;
    while (left > 0 && !::testing::Test::HasFailure()) {
        const std::uint64_t count = std::min(left, kMaterialsAtOnce);
        const Jobs jobs = random_jobs(chooser, model, count);
        for (const OwnedJob* owned : {&jobs.eval, &jobs.sample, &jobs.albedo, &jobs.lights}) {
            SCOPED_TRACE(kernel_shape(owned->kernel).name);
            const JobResult result = backend->run(owned->job());
            expect_no_nan_infinity_or_negative_light(*owned, result);
            if (owned == &jobs.albedo) albedo = std::max(albedo, largest_albedo(*owned, result));
        }
        left -= count;
    }
    fmt::print("{} queries of each kernel; largest albedo {:.5f}\n", query_count, albedo);
}

using BackendAndModel = std::tuple<std::string, Model>;

class RandomQueries : public ::testing::TestWithParam<BackendAndModel> {};

TEST_P(RandomQueries, GiveFiniteLightAndNoMoreThanThereWas) {
    const auto& [backend, model] = GetParam();
    const bool is_slow = backend == "wgsl-dawn" && is_stack(model);
    expect_sense_of_random_queries(backend, model, is_slow ? kQueriesOnSwiftShader : kFewQueries);
}

class TenMillionQueries : public ::testing::TestWithParam<BackendAndModel> {};

TEST_P(TenMillionQueries, GiveFiniteLightAndNoMoreThanThereWas) {
    const auto& [backend, model] = GetParam();
    expect_sense_of_random_queries(backend, model, kManyQueries);
}

std::string test_name(const ::testing::TestParamInfo<BackendAndModel>& test) {
    std::string name =
        fmt::format("{}_{}", std::get<0>(test.param), model_name(std::get<1>(test.param)));
    std::ranges::replace(name, '-', '_');
    return name;
}

const auto kTableModels =
    ::testing::Values(Model::coated_ggx, Model::coated_exact, Model::stack, Model::stack_symmetric);

INSTANTIATE_TEST_SUITE_P(Every, RandomQueries,
                         ::testing::Combine(::testing::ValuesIn(shader_backends()), kTableModels),
                         test_name);

INSTANTIATE_TEST_SUITE_P(Every, TenMillionQueries,
                         ::testing::Combine(::testing::Values("vulkan", "glsl", "wgsl-wgpu", "cpp"),
                                            kTableModels),
                         test_name);

}  // namespace
}  // namespace lacquer::test
