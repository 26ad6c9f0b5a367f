// For any finite input, however senseless, every backend returns finite numbers that are no
// negative light.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "backends/expect_light.h"
#include "backends/jobs.h"

namespace lacquer::test {
namespace {

constexpr float kDenormal = 1e-40f;
constexpr float kSmallest = std::numeric_limits<float>::denorm_min();
constexpr float kHuge = 1e38f;
constexpr float kLargest = std::numeric_limits<float>::max();
constexpr float kAlmostOne = 1.0f - 0x1p-24f;

// Directions that are none, and the edges of those that are.
const std::vector<glm::vec4> kStrangeDirections{
    {0, 0, 0, 0},
    {0, 0, 1, 0},
    {0, 0, -1, 0},
    {1, 0, 0, 0},
    {-1, 0, 0, 0},
    {0, -1, -0.0f, 0},
    {1, 0, kSmallest, 0},
    {1, 0, 1e-30f, 0},
    {-1, 0, 1e-8f, 0},
    {0.6f, 0, 0.8f, 0},
    {-0.6f, 0, -0.8f, 0},  // opposite to the one before
    {-0.6f, 0, 0.8f, 0},
    {kDenormal, -kDenormal, kDenormal, 0},
    {0, 0, kSmallest, 0},
    {0, 0, 1e-20f, 0},
    {kHuge, 0, 0, 0},
    {0, 0, kHuge, 0},
    {kHuge, -kHuge, kHuge, 0},
    {kLargest, kLargest, kLargest, 0},
    {-kLargest, 0, kSmallest, 0},
    {1e19f, 1e19f, 1e19f, 0},
    {0.1f, 0.2f, 3.0f, 0},
    {0, 0, kAlmostOne, 0},
};

const std::vector<glm::vec4> kEdgeNumbers{{0, 0, 0, 0},
                                          {kAlmostOne, kAlmostOne, kAlmostOne, 0},
                                          {0, kAlmostOne, 0, 0},
                                          {kAlmostOne, 0, kAlmostOne, 0},
                                          {0.5f, kSmallest, 0.5f, 0},
                                          {0.5f, 0.5f, kSmallest, 0}};

// Corners of the ranges of the material format.
std::vector<Material> extreme_materials() {
    std::vector<Base> bases{NoBase{}, LambertianBase{{0, 0.5, 1}}};
    std::vector<std::vector<Layer>> coats{{}};
    for (const Ndf ndf : {Ndf::ggx, Ndf::beckmann})
        for (const auto& alpha : {std::array{0.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}, {1e-3, 0.5}}) {
            const Microsurface facets{ndf, alpha};
            bases.push_back(ConductorBase{{0, 1, 5}, {0, 0, 10}, facets});
            bases.push_back(ConductorBase{{0, 0, 1e-30}, {1e-30, 1, 10}, facets});
            for (const double ior : {1.0 / 3.0, 1.0, 1.0 + 1e-7, 3.0})
                coats.push_back({{{ior, facets}, AbsorbingMedium{{0, 1e-30, 1}}}});
        }
    std::vector<Material> materials;
    for (const Base& base : bases)
        for (const auto& layers : coats)
            materials.push_back(
                {fmt::format("extreme {}", materials.size()), 1.0, layers, base, {}});
    return materials;
}

// The rows of `kernel` over all pairs (or all directions) for every material.
OwnedJob strange_job(Kernel kernel, Model model) {
    const auto& second = kernel == Kernel::sample ? kEdgeNumbers : kStrangeDirections;
    std::vector<glm::vec4> once;
    for (const glm::vec4& direction : kStrangeDirections) {
        if (kernel_shape(kernel).input_rows == 1) {
            once.push_back(direction);
            continue;
        }
        for (const glm::vec4& other : second) {
            once.push_back(direction);
            once.push_back(other);
        }
    }
    OwnedJob owned{kernel,
                   shadeable(extreme_materials(), model),
                   once.size() / kernel_shape(kernel).input_rows,
                   {},
                   {},
                   model};
    owned.parameters.point_count = 8;
    for (std::size_t i = 0; i < owned.materials.size(); ++i)
        owned.inputs.insert(owned.inputs.end(), once.begin(), once.end());
    return owned;
}

class BackendRobustness : public ::testing::TestWithParam<std::tuple<std::string, Kernel>> {};

TEST_P(BackendRobustness, ReturnsNoNanInfinityOrNegativeLight) {
    const auto& [name, kernel] = GetParam();
    std::string skipped;
    const auto backend = create_or_explain(name, skipped);
    if (!backend) GTEST_SKIP() << skipped;
    const OwnedJob owned = strange_job(kernel, Model::plain);
    expect_no_nan_infinity_or_negative_light(owned, backend->run(owned.job()));
}

class ModelRobustness : public ::testing::TestWithParam<std::tuple<std::string, Model>> {};

TEST_P(ModelRobustness, ReturnsNoNanInfinityOrNegativeLight) {
    const auto& [name, model] = GetParam();
    std::string skipped;
    const auto backend = create_or_explain(name, skipped);
    if (!backend) GTEST_SKIP() << skipped;
    for (const Kernel kernel : {Kernel::eval, Kernel::sample, Kernel::albedo, Kernel::lights}) {
        const OwnedJob owned = strange_job(kernel, model);
        SCOPED_TRACE(kernel_shape(kernel).name);
        expect_no_nan_infinity_or_negative_light(owned, backend->run(owned.job()));
    }
}

std::string model_test_name(const ::testing::TestParamInfo<ModelRobustness::ParamType>& test) {
    std::string name =
        fmt::format("{}_{}", std::get<0>(test.param), model_name(std::get<1>(test.param)));
    std::ranges::replace(name, '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Every, ModelRobustness,
                         ::testing::Combine(::testing::ValuesIn(shader_backends()),
                                            ::testing::ValuesIn(other_models())),
                         model_test_name);

std::string test_name(const ::testing::TestParamInfo<BackendRobustness::ParamType>& test) {
    std::string name = std::get<0>(test.param);
    std::ranges::replace(name, '-', '_');
    return fmt::format("{}_{}", name, kernel_shape(std::get<1>(test.param)).name);
}

INSTANTIATE_TEST_SUITE_P(Every, BackendRobustness,
                         ::testing::Combine(::testing::ValuesIn(shader_backends()),
                                            ::testing::Values(Kernel::eval, Kernel::sphere,
                                                              Kernel::slice, Kernel::sample,
                                                              Kernel::albedo)),
                         test_name);

}  // namespace
}  // namespace lacquer::test
