#include "codegen/naga.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/paths.h"
#include "core/process.h"

namespace lacquer::codegen {

namespace {

using Json = nlohmann::json;

std::filesystem::path naga_folder() {
    return share_folder() / "node" / "naga";
}

// One conversation with naga.mjs: a list of jobs in, a list of answers out.
Json ask_naga(const Json& jobs) {
    const WgslAvailability availability = wgsl_availability();
    if (!availability.usable) throw Error{availability.reason};
    const ProcessResult result =
        run_process(*node_program(), {(naga_folder() / "naga.mjs").string()}, jobs.dump());
    if (result.exit_code != 0) throw Error{fmt::format("naga stopped: {}", result.err)};
    return Json::parse(result.out);
}

}  // namespace

WgslAvailability wgsl_availability() {
    if (!node_program()) return {false, "WGSL needs Node.js: " + node_missing_message()};
    const std::filesystem::path package = naga_folder() / "node_modules" / "naga-wasm";
    if (!std::filesystem::exists(package))
        return {false, fmt::format("WGSL needs the npm package naga-wasm, and '{}' is missing: run "
                                   "'npm ci' in codegen/wgsl",
                                   package.string())};
    return {true, {}};
}

std::vector<std::string> translate_to_wgsl(std::span<const NagaJob> jobs) {
    if (jobs.empty()) return {};
    Json request = Json::array();
    for (const NagaJob& job : jobs) request.push_back({{"spirv", job.words}});
    const Json answers = ask_naga(request);
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        if (answers.at(i).contains("error"))
            throw Error{
                fmt::format("{}: naga: {}", jobs[i].name, answers[i]["error"].get<std::string>())};
        texts.push_back(answers[i].at("wgsl"));
    }
    return texts;
}

std::vector<NagaAnswer> translate_from_wgsl(std::span<const std::string> texts) {
    if (texts.empty()) return {};
    Json request = Json::array();
    for (const std::string& text : texts) request.push_back({{"wgsl", text}});
    const Json answers = ask_naga(request);
    std::vector<NagaAnswer> translated;
    for (const Json& answer : answers)
        translated.push_back(
            {answer.value("spirv", Words{}), answer.value("error", std::string{})});
    return translated;
}

}  // namespace lacquer::codegen
