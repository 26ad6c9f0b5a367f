// The manifest of generated files.
#include <nlohmann/json.hpp>

#include "codegen/codegen.h"
#include "core/version.h"

namespace lacquer::codegen {

namespace {

using Json = nlohmann::ordered_json;

Json to_json(const EntryPoint& point) {
    Json json{{"name", point.name}, {"stage", point.stage}};
    if (point.stage == "compute") json["workgroup_size"] = point.workgroup_size;
    return json;
}

Json to_json(const Function& function) {
    return {
        {"name", function.name}, {"signature", function.signature}, {"summary", function.summary}};
}

Json to_json(const Binding& binding) {
    return {{"name", binding.name},
            {"set", binding.set},
            {"binding", binding.binding},
            {"kind", binding.kind}};
}

template <typename T>
Json to_json(const std::vector<T>& list) {
    Json json = Json::array();
    for (const T& element : list) json.push_back(to_json(element));
    return json;
}

Json to_json(const ShaderFile& file) {
    return {{"path", file.path.generic_string()},
            {"target", target_name(file.target)},
            {"form", form_name(file.form)},
            {"level", file.level},
            {"kernel", file.kernel},
            {"entry_points", to_json(file.entry_points)},
            {"functions", to_json(file.functions)},
            {"bindings", to_json(file.bindings)},
            {"tables", Json::array()},
            {"instruction_count", file.instruction_count},
            {"table_reads", 0},
            {"bytes", file.contents.size()},
            {"sha256", file.sha256}};
}

}  // namespace

std::string manifest(const Package& package) {
    Json list = Json::array();
    for (const ShaderFile& file : package.files) list.push_back(to_json(file));
    const Json json{
        {"version", kVersion}, {"source_sha256", package.source_sha256}, {"files", list}};
    return json.dump(2) + "\n";
}

}  // namespace lacquer::codegen
