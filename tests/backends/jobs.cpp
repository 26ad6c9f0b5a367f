#include "backends/jobs.h"

#include "core/model_scope.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace lacquer::test {

namespace {

constexpr double kPi = std::numbers::pi;

// Increments of the two-dimensional golden-ratio sequence and of its one-dimensional companion.
constexpr double kStepU = 0.7548776662466927;
constexpr double kStepV = 0.5698402909980532;
constexpr double kStepW = 0.6180339887498949;

double fraction(double x) {
    return x - std::floor(x);
}

glm::vec4 direction(double cos_theta, double phi) {
    const double sin_theta = std::sqrt((1.0 - cos_theta) * (1.0 + cos_theta));
    return {sin_theta * std::cos(phi), sin_theta * std::sin(phi), cos_theta, 0.0};
}

// Three uniform numbers per row.
std::vector<glm::vec4> uniforms(std::size_t count) {
    std::vector<glm::vec4> rows;
    for (std::size_t i = 0; i < count; ++i) {
        const double n = static_cast<double>(i) + 0.5;
        rows.emplace_back(fraction(n * kStepW), fraction(n * kStepU), fraction(n * kStepV), 0.0);
    }
    return rows;
}

Layer coat(double ior, Ndf ndf, double alpha_x, double alpha_y) {
    return {{ior, Microsurface{ndf, {alpha_x, alpha_y}}}, AbsorbingMedium{}};
}

std::vector<glm::vec4> interleaved(const std::vector<glm::vec4>& even,
                                   const std::vector<glm::vec4>& odd) {
    std::vector<glm::vec4> rows;
    rows.reserve(even.size() + odd.size());
    for (std::size_t i = 0; i < even.size(); ++i) {
        rows.push_back(even[i]);
        rows.push_back(odd[i]);
    }
    return rows;
}

}  // namespace

Job OwnedJob::job() const {
    return {model, kernel, materials, queries_per_material, inputs, parameters};
}

std::vector<Model> other_models() {
    std::vector<Model> models;
    for (const Model model : all_models())
        if (model != Model::plain) models.push_back(model);
    return models;
}

namespace {

std::vector<Material> uniform_materials() {
    const Rgb gold_eta{0.143, 0.375, 1.442};
    const Rgb gold_kappa{3.983, 2.386, 1.603};
    const ConductorBase gold{gold_eta, gold_kappa, Microsurface{Ndf::ggx, {0.2, 0.2}}};
    const ConductorBase brushed{gold_eta, gold_kappa, Microsurface{Ndf::beckmann, {0.1, 0.6}}};
    const Layer tinted{{1.6, Microsurface{Ndf::ggx, {0.2, 0.2}}}, AbsorbingMedium{{0.9, 0.4, 0}}};
    return {{"glazed", 1.0, {coat(1.5, Ndf::ggx, 0.1, 0.1)}, LambertianBase{{0.8, 0.5, 0.1}}, {}},
            {"metal", 1.0, {}, gold, {}},
            {"brushed", 1.33, {}, brushed, {}},
            {"glass", 1.0, {coat(1.7, Ndf::beckmann, 0.4, 0.4)}, NoBase{}, {}},
            {"bubble", 1.5, {coat(1.0, Ndf::ggx, 0.3, 0.8)}, LambertianBase{{1, 1, 1}}, {}},
            {"varnished metal", 1.0, {coat(1.4, Ndf::ggx, 0.05, 0.05)}, brushed, {}},
            {"tinted", 1.0, {tinted}, LambertianBase{{0.8, 0.8, 0.8}}, {}},
            {"tinted metal", 1.0, {tinted}, gold, {}}};
}

Stratum stratum(double weight, Ndf ndf, double alpha_x, double alpha_y) {
    return {weight, {ndf, {alpha_x, alpha_y}}, {}, {}, {}};
}

std::vector<Material> blended_materials() {
    using Op = Blend::Operator;
    const Rgb eta{0.2, 0.9, 1.1}, kappa{3.9, 2.5, 2.4};
    Blend worn{Op::asymmetric,
               {stratum(0.4, Ndf::ggx, 0.1, 0.1), stratum(0.6, Ndf::beckmann, 0.5, 0.5)}};
    worn.strata[0].eta = {1.5, 0.9, 0.6};
    worn.strata[0].kappa = {7.2, 6.4, 5.3};
    const Blend hazy{Op::symmetric,
                     {stratum(0.7, Ndf::ggx, 0.1, 0.3), stratum(0.3, Ndf::ggx, 0.6, 0.6)}};
    const Blend pitted{Op::asymmetric,
                       {stratum(0.5, Ndf::ggx, 0.2, 0.2), stratum(0.2, Ndf::ggx, 0.7, 0.4),
                        stratum(0.3, Ndf::beckmann, 0.3, 0.3)}};
    return {{"worn metal", 1.0, {}, ConductorBase{eta, kappa, worn}, {}},
            {"hazy metal", 1.0, {}, ConductorBase{eta, kappa, hazy}, {}},
            {"hazy glass", 1.0, {{{1.5, hazy}, AbsorbingMedium{{0.9, 0.5, 0.1}}}}, NoBase{}, {}},
            {"pitted glass", 1.0, {{{1.8, pitted}, AbsorbingMedium{}}}, NoBase{}, {}},
            {"bubble in glass", 1.5, {{{1.0, pitted}, AbsorbingMedium{}}}, NoBase{}, {}}};
}

}  // namespace

std::vector<Material> test_materials() {
    std::vector<Material> materials = uniform_materials();
    std::ranges::move(blended_materials(), std::back_inserter(materials));
    return materials;
}

std::vector<Material> shadeable(std::vector<Material> materials, Model model) {
    std::erase_if(materials, [model](const Material& material) {
        return why_not_shadeable(material, model).has_value();
    });
    return materials;
}

std::vector<glm::vec4> directions(std::size_t count, double stream) {
    std::vector<glm::vec4> rows;
    rows.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double n = static_cast<double>(i) + 0.5;
        double cos_theta = fraction(n * kStepU + stream);
        if (i % 8 == 3) cos_theta *= std::sin(kPi / 180.0);
        if (i % 64 == 5) cos_theta = 1.0;
        rows.push_back(direction(cos_theta, 2.0 * kPi * fraction(n * kStepV - stream)));
    }
    return rows;
}

OwnedJob make_job(Kernel kernel, std::vector<Material> materials,
                  std::uint64_t queries_per_material) {
    OwnedJob owned{kernel, std::move(materials), queries_per_material, {}, {}};
    const std::size_t count = owned.materials.size() * queries_per_material;
    const glm::vec4 wo = direction(0.3, 0.5);
    for (int axis = 0; axis < 3; ++axis) {
        owned.parameters.wo[axis] = wo[axis];
        owned.parameters.radiance[axis] = 1.0f + static_cast<float>(axis);
    }
    owned.inputs = directions(count, 0.0);
    if (kernel == Kernel::sample)
        owned.inputs = interleaved(owned.inputs, uniforms(count));
    else if (kernel_shape(kernel).input_rows == 2)
        owned.inputs = interleaved(owned.inputs, directions(count, 0.37));
    return owned;
}

std::vector<std::string> shader_backends() {
    std::vector<std::string> names;
    for (const BackendEntry& entry : all_backends())
        if (entry.name != "reference") names.emplace_back(entry.name);
    return names;
}

std::unique_ptr<Backend> create_or_explain(const std::string& name, std::string& skipped,
                                           const BackendOptions& options) {
    const BackendEntry& entry = backend_from_name(name);
    const Availability availability = entry.probe(options);
    if (availability.usable) return entry.create(options);
    skipped = fmt::format("{}: {} ({})", name, availability.detail, availability.remedy);
    return nullptr;
}

}  // namespace lacquer::test
