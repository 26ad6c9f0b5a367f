// Every backend that runs here computes what the reference computes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "backends/jobs.h"
#include "backends/truth.h"
#include "compare/tolerances.h"
#include "lacquer/bsdf.h"
#include "material/numbers.h"

namespace lacquer::test {
namespace {

// Float has 24 bits: a formula of a hundred operations keeps about 5 digits in the worst place and
// nearly 7 in the middle. The same figures as those of `lacquer compare`.
constexpr double kMaxRelativeError = 1e-4;
constexpr double kMedianRelativeError = 3e-7;

// Below this an error counts in absolute terms.
constexpr double kSmallValue = 1e-3;

// Of the kernel of that name.
constexpr std::uint32_t kLights = 3;

double relative_error(double value, double expected) {
    return std::abs(value - expected) / std::max(std::abs(expected), kSmallValue);
}

void expect_agreement(const Rows& rows, const Rows& expected,
                      const Tolerance& tolerance = {kMaxRelativeError, kMedianRelativeError}) {
    ASSERT_EQ(rows.size(), expected.size());
    std::vector<double> errors;
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (int c = 0; c < 4; ++c) {
            errors.push_back(relative_error(rows[i][c], expected[i][c]));
            // Written so that NaN fails, too.
            ASSERT_TRUE(errors.back() <= tolerance.max_rel)
                << fmt::format("row {} component {}: {}, expected {}, relative error {}", i, c,
                               rows[i][c], expected[i][c], errors.back());
        }
    std::ranges::nth_element(errors, errors.begin() + errors.size() / 2);
    EXPECT_LE(errors[errors.size() / 2], tolerance.median_rel);
}

class BackendAgreement : public ::testing::TestWithParam<std::tuple<std::string, Kernel>> {};

TEST_P(BackendAgreement, WithTheReference) {
    const auto& [name, kernel] = GetParam();
    std::string skipped;
    const auto backend = create_or_explain(name, skipped);
    if (!backend) GTEST_SKIP() << skipped;
    // An albedo is hundreds of evaluations.
    const std::uint64_t queries_per_material = kernel == Kernel::albedo ? 64 : 4096;
    OwnedJob owned =
        make_job(kernel, shadeable(test_materials(), Model::plain), queries_per_material);
    if (kernel == Kernel::lights) owned.parameters.point_count = kLights;
    const JobResult result = backend->run(owned.job());
    EXPECT_GT(result.seconds, 0.0);
    expect_agreement(result.rows, expected_rows(owned.job(), result.rows));
}

// Through a stack into a thinner medium light leaves, beyond the critical angle, as a lobe at
// grazing that is as narrow as kMinAlpha: there pdf and f answer to the last digits of a direction
// (README, limits), by up to 4 u / (0.014 kMinAlpha) = 1.7e-2.
bool leaves_at_grazing(const Material& material, Model model) {
    const bool is_stack = model == Model::stack || model == Model::stack_symmetric;
    return is_stack && std::holds_alternative<NoBase>(material.base) &&
           material.layers.back().interface.ior < material.exterior_ior;
}

std::vector<Material> materials_for(Model model) {
    std::vector<Material> materials = shadeable(test_materials(), model);
    std::erase_if(materials, [model](const Material& m) { return leaves_at_grazing(m, model); });
    return materials;
}

// The other models on what tells them from `plain`: fewer queries, and a process per model, not per
// kernel.
class ModelAgreement : public ::testing::TestWithParam<std::tuple<std::string, Model>> {};

TEST_P(ModelAgreement, WithTheReference) {
    const auto& [name, model] = GetParam();
    std::string skipped;
    const auto backend = create_or_explain(name, skipped);
    if (!backend) GTEST_SKIP() << skipped;
    for (const Kernel kernel :
         {Kernel::eval, Kernel::sphere, Kernel::sample, Kernel::albedo, Kernel::lights}) {
        OwnedJob owned =
            make_job(kernel, materials_for(model), kernel == Kernel::albedo ? 32 : 1024);
        owned.model = model;
        if (kernel == Kernel::lights) owned.parameters.point_count = kLights;
        const JobResult result = backend->run(owned.job());
        SCOPED_TRACE(kernel_shape(kernel).name);
        expect_agreement(result.rows, expected_rows(owned.job(), result.rows),
                         tolerance_of(name, model));
    }
}

std::string model_test_name(const ::testing::TestParamInfo<ModelAgreement::ParamType>& test) {
    std::string name =
        fmt::format("{}_{}", std::get<0>(test.param), model_name(std::get<1>(test.param)));
    std::ranges::replace(name, '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Every, ModelAgreement,
                         ::testing::Combine(::testing::ValuesIn(shader_backends()),
                                            ::testing::ValuesIn(other_models())),
                         model_test_name);

// Two ways to write a model, both in double: what differs is a formula, not rounding.
class Formula : public ::testing::TestWithParam<Model> {};

TEST_P(Formula, OfTheShaderSourceIsThatOfTheReference) {
    constexpr double kPolynomials = 1e-6;  // twice what they are worth: core/math.glsl
    // What meets several facets, m(wi) m(wo) / (pi mean m), is made of differences from 1: of
    // smooth facets the three are small, and off by as much as the 1.
    const double several = GetParam() == Model::microsurface_compensated
                               ? 3.0 * kPolynomials * std::numbers::inv_pi
                               : 0.0;
    OwnedJob owned = make_job(Kernel::eval, shadeable(test_materials(), GetParam()), 512);
    owned.model = GetParam();
    const Rows reference = backend_from_name("reference").create({})->run(owned.job()).rows;
    std::vector<Bsdf<double>> surfaces;
    for (const Material& material : owned.materials)
        surfaces.push_back(prepare<double>(as_shaders_read(material), owned.model));
    for (std::size_t query = 0; query < reference.size(); ++query) {
        const Material& material = owned.materials[query / owned.queries_per_material];
        const Bsdf<double>& bsdf = surfaces[query / owned.queries_per_material];
        const glm::dvec3 wi{owned.inputs[2 * query]};
        const glm::dvec3 wo{owned.inputs[2 * query + 1]};
        const glm::dvec4 row{bsdf.eval(wi, wo), bsdf.pdf(wi, wo)};
        for (int c = 0; c < 4; ++c)
            ASSERT_TRUE(std::abs(row[c] - reference[query][c]) <= several ||
                        relative_error(row[c], reference[query][c]) <= kPolynomials)
                << material.name << " query " << query << " component " << c << ": " << row[c]
                << ", expected " << reference[query][c];
    }
}

INSTANTIATE_TEST_SUITE_P(Every, Formula, ::testing::ValuesIn(all_models()), [](const auto& test) {
    std::string name{model_name(test.param)};
    std::ranges::replace(name, '-', '_');
    return name;
});

std::string test_name(const ::testing::TestParamInfo<BackendAgreement::ParamType>& test) {
    std::string name = std::get<0>(test.param);
    std::ranges::replace(name, '-', '_');
    return fmt::format("{}_{}", name, kernel_shape(std::get<1>(test.param)).name);
}

INSTANTIATE_TEST_SUITE_P(Every, BackendAgreement,
                         ::testing::Combine(::testing::ValuesIn(shader_backends()),
                                            ::testing::ValuesIn(kAllKernels)),
                         test_name);

}  // namespace
}  // namespace lacquer::test
