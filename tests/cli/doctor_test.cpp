// `lacquer doctor` tells the truth with and without what backends need.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "backends/backend.h"
#include "cli/run_lacquer.h"
#include "core/environment.h"

namespace lacquer {
namespace {

using nlohmann::json;
using test::expect_success;
using test::run_lacquer;
using ::testing::HasSubstr;
using ::testing::SizeIs;

json examine() {
    const ProcessResult result = run_lacquer({"doctor", "--json"});
    expect_success(result);
    return json::parse(result.out);
}

json finding(const json& report, const std::string& list, const std::string& name) {
    for (const json& entry : report.at(list))
        if (entry.at("name") == name) return entry;
    ADD_FAILURE() << name << " is not in " << list;
    return {};
}

void expect_missing(const json& entry) {
    EXPECT_FALSE(entry.at("usable").get<bool>()) << entry;
    EXPECT_FALSE(entry.at("detail").get<std::string>().empty()) << entry;
    EXPECT_FALSE(entry.at("remedy").get<std::string>().empty()) << entry;
}

TEST(Doctor, ExaminesEveryBackendAndAgreesWithItsProbe) {
    const json report = examine();
    EXPECT_THAT(report.at("backends"), SizeIs(all_backends().size()));
    for (const BackendEntry& entry : all_backends())
        EXPECT_EQ(finding(report, "backends", std::string{entry.name}).at("usable"),
                  entry.probe({}).usable)
            << entry.name;
}

TEST(Doctor, PrintsATable) {
    const ProcessResult result = run_lacquer({"doctor"});
    expect_success(result);
    for (const BackendEntry& entry : all_backends())
        EXPECT_THAT(result.out, HasSubstr(std::string{entry.name}));
}

TEST(Doctor, MissesAVulkanDriver) {
    ScopedEnvironment environment;
    environment.set("VK_ICD_FILENAMES", "/nowhere/icd.json");
    const json report = examine();
    expect_missing(finding(report, "backends", "vulkan"));
    EXPECT_TRUE(finding(report, "backends", "cpp").at("usable").get<bool>());
}

TEST(Doctor, MissesEgl) {
    ScopedEnvironment environment;
    environment.set("__EGL_VENDOR_LIBRARY_FILENAMES", "/nowhere/egl.json");
    const json report = examine();
    expect_missing(finding(report, "backends", "glsl"));
    expect_missing(finding(report, "backends", "essl"));
}

TEST(Doctor, MissesNode) {
    ScopedEnvironment environment;
    environment.set("LACQUER_NODE", "/nowhere/node");
    const json report = examine();
    expect_missing(finding(report, "tools", "node"));
    expect_missing(finding(report, "backends", "wgsl-dawn"));
}

TEST(Doctor, MissesChromium) {
    ScopedEnvironment environment;
    environment.set("LACQUER_SWIFTSHADER_ICD", "/nowhere/icd.json");
    environment.set("PATH", "/nowhere");
    const json report = examine();
    expect_missing(finding(report, "tools", "chromium"));
    expect_missing(finding(report, "backends", "wgsl-dawn"));
}

}  // namespace
}  // namespace lacquer
