// The manifest of generated files.
#include <nlohmann/json.hpp>

#include "codegen/codegen.h"
#include "core/version.h"

namespace lacquer::codegen {

namespace {

using Json = nlohmann::ordered_json;

// All tables are packed as one.
constexpr const char* kTables = "lacquer_tables";

Json to_json(const EntryPoint& point) {
    Json json{{"name", point.name}, {"stage", point.stage}};
    if (point.stage == "compute") json["workgroup_size"] = point.workgroup_size;
    json["instruction_count"] = point.instruction_count;
    return json;
}

Json to_json(const Function& function) {
    Json json{
        {"name", function.name}, {"signature", function.signature}, {"summary", function.summary}};
    if (function.instruction_count) json["instruction_count"] = *function.instruction_count;
    return json;
}

Json to_json(const Binding& binding) {
    return {{"name", binding.name},
            {"set", binding.set},
            {"binding", binding.binding},
            {"kind", binding.kind}};
}

Json to_json(const ShaderFile& file);
Json to_json(const TableFile& table);

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
            {"tables", file.table_reads > 0 ? Json::array({kTables}) : Json::array()},
            {"instruction_count", file.instruction_count},
            {"table_reads", file.table_reads},
            {"bytes", file.contents.size()},
            {"sha256", file.sha256}};
}

Json to_json(const StackChoices& stacks) {
    return {{"max_layers", stacks.max_layers}, {"lobes", stacks.lobes}};
}

Json to_json(const TableFile& table) {
    return {
        {"path", table.path.generic_string()}, {"name", kTables},       {"format", table.format},
        {"texel_count", table.texel_count},    {"width", table.width},  {"height", table.height},
        {"bytes", table.contents.size()},      {"sha256", table.sha256}};
}

}  // namespace

std::string manifest(const Package& package) {
    const Json json{{"version", kVersion},
                    {"source_sha256", package.source_sha256},
                    {"stacks", to_json(package.stacks)},
                    {"files", to_json(package.files)},
                    {"tables", to_json(package.tables)}};
    return json.dump(2) + "\n";
}

}  // namespace lacquer::codegen
