#include <gmock/gmock.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <numbers>

#include "cli/run_lacquer.h"
#include "core/environment.h"
#include "core/file.h"
#include "core/model.h"
#include "support/temporary_folder.h"

namespace lacquer {
namespace {

// Two more multiplications in float.
constexpr double kFloatRounding = 2.4e-7;

using nlohmann::json;
using test::expect_success;
using test::kFailure;
using test::run_lacquer;
using test::TemporaryFolder;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::SizeIs;

TEST(CompareCommand, PassesTheShaderSourceAsCpp) {
    const ProcessResult result =
        run_lacquer({"compare", "--backend", "cpp", "--material", "gold", "--json"});
    expect_success(result);
    const json backends = json::parse(result.out).at("backends");
    ASSERT_THAT(backends, SizeIs(1));
    EXPECT_EQ(backends[0].at("status"), "passed");
    const json& material = backends[0].at("materials").at(0);
    EXPECT_EQ(material.at("name"), "gold");
    EXPECT_GT(material.at("max_rel").get<double>(), 0.0);
    EXPECT_LT(material.at("max_rel").get<double>(), 1e-4);
}

// The coated models shade no metal, and that of one surface no coat.
std::string shaded_by(Model model) {
    if (model == Model::microsurface_single || model == Model::microsurface_compensated)
        return "gold";
    return reads_tables(model) ? "porcelain" : "lacquered_copper";
}

TEST(CompareCommand, PassesEveryModelAsCpp) {
    for (const Model model : all_models())
        expect_success(run_lacquer({"compare", "--backend", "cpp", "--material", shaded_by(model),
                                    "--model", std::string{model_name(model)}}));
}

TEST(CompareCommand, NamesWhatAModelCannotShade) {
    const TemporaryFolder folder;
    const std::string file = (folder / "two.json").string();
    write_file(file, R"({"name": "two", "layers": [{"interface": {"ior": 1.5, "alpha": 0.1}},
        {"interface": {"ior": 1.3, "alpha": 0.1}}], "base": "none"})");
    const ProcessResult result =
        run_lacquer({"compare", "--backend", "cpp", "--material", file, "--model", "clearcoat"});
    EXPECT_EQ(result.exit_code, kFailure);
    EXPECT_THAT(result.err, HasSubstr("material 'two': /layers/1: the model 'clearcoat' shades at "
                                      "most one layer"));
}

TEST(CompareCommand, WritesItsReport) {
    const TemporaryFolder folder;
    expect_success(run_lacquer({"compare", "--backend", "cpp", "--material", "gold", "--report",
                                (folder / "report").string()}));
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator{folder / "report"})
        names.push_back(entry.path().filename());
    EXPECT_THAT(names, IsSupersetOf({"report.html", "compare.json", "junit.xml"}));
    EXPECT_EQ(json::parse(read_file(folder / "report/compare.json")).at("backends").size(), 1u);
}

TEST(CompareCommand, FailsForANamedBackendThatCannotRun) {
    ScopedEnvironment environment;
    environment.set("VK_ICD_FILENAMES", "/nowhere/icd.json");
    const ProcessResult result =
        run_lacquer({"compare", "--backend", "vulkan", "--material", "gold"});
    EXPECT_EQ(result.exit_code, kFailure);
    EXPECT_THAT(result.out, HasSubstr("skipped"));
    EXPECT_THAT(result.err, HasSubstr("lacquer: backend 'vulkan' cannot run here"));
}

TEST(CompareCommand, ReplaysTheWorstQueryThroughEval) {
    const ProcessResult compared =
        run_lacquer({"compare", "--backend", "cpp", "--material", "gold", "--json"});
    expect_success(compared);
    const json worst = json::parse(compared.out).at("backends")[0].at("materials")[0].at("worst");
    const std::string command = worst.at("replay");
    const std::string start = "| lacquer ";
    ASSERT_THAT(command, HasSubstr(start));
    const std::string piped = command.substr(0, command.find(start)) + "| '" + LACQUER_PROGRAM +
                              "' " + command.substr(command.find(start) + start.size());
    const ProcessResult replayed = run_process("/bin/sh", {"-c", piped});
    expect_success(replayed);
    const std::string row = replayed.out.substr(replayed.out.find('\n') + 1);
    double values[4] = {};
    ASSERT_EQ(std::sscanf(row.c_str(), "%*g,%*g,%*g,%*g,%*g,%*g,%lf,%lf,%lf,%lf", &values[0],
                          &values[1], &values[2], &values[3]),
              4);
    // A sphere's radiance is pi f cos_theta_i.
    const std::string component = worst.at("component");
    const bool sphere = component.starts_with("radiance");
    const double scale = sphere ? std::numbers::pi * worst.at("wi")[2].get<double>() : 1.0;
    const std::size_t index = component == "pdf" ? 3 : std::string{"rgb"}.find(component.back());
    const double value = worst.at("value");
    EXPECT_NEAR(scale * values[index], value, kFloatRounding * value) << component;
}

TEST(CompareCommand, PrintsAndUpdatesTheAccuracyTable) {
    const TemporaryFolder folder;
    const std::string readme = (folder / "README.md").string();
    write_file(readme,
               "before\n<!-- accuracy: written by `lacquer compare --update-readme` -->\nold\n"
               "<!-- end of accuracy -->\nafter\n");
    const ProcessResult result =
        run_lacquer({"compare", "--backend", "cpp", "--markdown", "--update-readme", readme});
    expect_success(result);
    EXPECT_THAT(result.out, HasSubstr("| cpp |"));
    const std::string updated = read_file(readme);
    EXPECT_THAT(updated, HasSubstr(result.out));
    EXPECT_THAT(updated, ::testing::Not(HasSubstr("old")));
}

TEST(CompareCommand, DoesNotMakeTheTableOfAllMaterialsFromSome) {
    const ProcessResult result = run_lacquer(
        {"compare", "--backend", "cpp", "--material", "gold", "--update-readme", "README.md"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr("--material"));
}

}  // namespace
}  // namespace lacquer
