#include "report/json.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/version.h"

namespace lacquer {

namespace {

using Json = nlohmann::ordered_json;

// The shortest decimal that reads back as this very float.
double exact_number(float value) {
    return std::stod(fmt::format("{}", value));
}

Json direction_json(const glm::vec3& w) {
    return {exact_number(w.x), exact_number(w.y), exact_number(w.z)};
}

Json number_json(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json worst_json(const BackendResult& backend, const MaterialResult& material) {
    const WorstQuery& worst = material.worst;
    return {{"wi", direction_json(worst.query.wi)},
            {"wo", direction_json(worst.query.wo)},
            {"grid", worst.grid},
            {"component", worst.component},
            {"value", number_json(worst.value)},
            {"reference", number_json(worst.reference)},
            {"replay", replay_command(backend, material)}};
}

Json material_json(const BackendResult& backend, const MaterialResult& material) {
    const ErrorSummary& errors = material.errors;
    return {{"name", material.name},
            {"passed", material.passed},
            {"queries", errors.queries},
            {"non_finite", errors.non_finite},
            {"max_abs", number_json(errors.max_abs)},
            {"mean_abs", number_json(errors.mean_abs)},
            {"max_rel", number_json(errors.max_rel)},
            {"p999_rel", number_json(errors.p999_rel)},
            {"median_rel", number_json(errors.median_rel)},
            {"worst", worst_json(backend, material)},
            {"queries_per_second", material.queries_per_second}};
}

Json backend_json(const BackendResult& backend) {
    Json materials = Json::array();
    for (const MaterialResult& material : backend.materials)
        materials.push_back(material_json(backend, material));
    return {
        {"name", backend.name},
        {"status", status_name(backend.status)},
        {"reason", backend.reason},
        {"device", backend.device},
        {"tolerance",
         {{"max_rel", backend.tolerance.max_rel}, {"median_rel", backend.tolerance.median_rel}}},
        {"materials", materials}};
}

}  // namespace

std::string compare_json(const CompareResult& result) {
    Json backends = Json::array();
    for (const BackendResult& backend : result.backends) backends.push_back(backend_json(backend));
    const Json json = {{"version", kVersion},
                       {"model", model_name(result.model)},
                       {"suite", result.suite},
                       {"reference",
                        {{"device", result.reference_device},
                         {"queries_per_second", result.reference_queries_per_second}}},
                       {"backends", backends}};
    return json.dump(2) + "\n";
}

}  // namespace lacquer
