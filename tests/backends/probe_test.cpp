// Backends tell the truth about what is missing, in environments that lack things.
#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "backends/jobs.h"
#include "core/environment.h"
#include "core/file.h"
#include "core/paths.h"
#include "core/process.h"
#include "support/temporary_folder.h"

namespace lacquer::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

struct Report {
    bool usable = false;
    std::string detail, remedy;
};
using Reports = std::map<std::string, Report>;

// Runs the probes in the environment as it is now.
Reports probe_all(const fs::path& program = BACKENDS_PROBE) {
    const ProcessResult result = run_process(program, {});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    Reports reports;
    std::istringstream lines{result.out};
    for (std::string line; std::getline(lines, line);) {
        std::istringstream fields{line};
        std::string name, state;
        Report report;
        std::getline(fields, name, '\t');
        std::getline(fields, state, '\t');
        std::getline(fields, report.detail, '\t');
        std::getline(fields, report.remedy, '\t');
        report.usable = state == "usable";
        reports[name] = report;
    }
    EXPECT_EQ(reports.size(), all_backends().size()) << result.out << result.err;
    return reports;
}

// Expects `names` to be missing for a reason with `reason` and a remedy with `remedy`, and the
// other backends to be as they were in `before`.
void expect_missing(const Reports& before, const std::vector<std::string>& names,
                    const std::string& reason, const std::string& remedy) {
    for (const auto& [name, report] : probe_all()) {
        SCOPED_TRACE(name);
        if (std::ranges::find(names, name) == names.end()) {
            EXPECT_EQ(report.usable, before.at(name).usable);
        } else if (before.at(name).usable) {
            EXPECT_FALSE(report.usable);
            EXPECT_THAT(report.detail, HasSubstr(reason));
            EXPECT_THAT(report.remedy, HasSubstr(remedy));
        }
    }
}

class Probe : public ::testing::Test {
 protected:
    void SetUp() override {
        environment_.unset("VK_ICD_FILENAMES");
        environment_.unset("VK_DRIVER_FILES");
        before_ = probe_all();
    }

    // Makes the dynamic linker find something that is no library.
    void break_library(const std::string& name) {
        write_file(folder_ / name, "no library");
        environment_.set("LD_LIBRARY_PATH", folder_.path().string());
    }

    TemporaryFolder folder_;
    ScopedEnvironment environment_;
    Reports before_;
};

TEST_F(Probe, GivesADeviceOrAReasonAndARemedy) {
    EXPECT_TRUE(before_.at("reference").usable);
    EXPECT_TRUE(before_.at("cpp").usable);
    for (const auto& [name, report] : before_) {
        SCOPED_TRACE(name);
        EXPECT_THAT(report.detail, Not(IsEmpty()));
        if (report.usable) continue;
        EXPECT_THAT(report.remedy, Not(IsEmpty()));
    }
}

TEST_F(Probe, MissesADriverThatTheUserChose) {
    environment_.set("VK_ICD_FILENAMES", "/nonexistent/icd.json");
    expect_missing(before_, {"vulkan", "hlsl", "wgsl-wgpu"},
                   "VK_ICD_FILENAMES=/nonexistent/icd.json", "unset VK_ICD_FILENAMES");
}

TEST_F(Probe, MissesADriverThatIsBroken) {
    write_file(folder_ / "icd.json", "{ broken");
    environment_.set("VK_DRIVER_FILES", (folder_ / "icd.json").string());
    expect_missing(before_, {"vulkan", "hlsl", "wgsl-wgpu"},
                   "VK_DRIVER_FILES=", "unset VK_DRIVER_FILES");
}

TEST_F(Probe, MissesEglLibrary) {
    break_library("libEGL.so.1");
    expect_missing(before_, {"glsl", "essl"}, "libEGL.so.1", "apt-get install libegl1");
}

TEST_F(Probe, MissesOpenglLibrary) {
    break_library("libGL.so.1");
    expect_missing(before_, {"glsl"}, "libGL.so.1", "apt-get install libgl1");
}

TEST_F(Probe, MissesOpenglEsLibrary) {
    break_library("libGLESv2.so.2");
    expect_missing(before_, {"essl"}, "libGLESv2.so.2", "apt-get install libgles2");
}

TEST_F(Probe, MissesEglDriver) {
    environment_.set("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent.json");
    expect_missing(before_, {"glsl", "essl"}, "EGL has no driver", "apt-get install libegl-mesa0");
}

TEST_F(Probe, MissesNode) {
    environment_.set("LACQUER_NODE", "/nonexistent/node");
    expect_missing(before_, {"wgsl-dawn"}, "Node.js", "LACQUER_NODE");
}

TEST_F(Probe, MissesSwiftShader) {
    environment_.set("LACQUER_SWIFTSHADER_ICD", "/nonexistent/icd.json");
    expect_missing(before_, {"wgsl-dawn"}, "/nonexistent/icd.json", "apt-get install chromium");
}

TEST_F(Probe, MissesNodePackages) {
    environment_.set("LACQUER_SHARE", folder_.path().string());
    expect_missing(before_, {"wgsl-wgpu", "wgsl-dawn", "hlsl-fxc"}, "is missing", "npm ci");
}

TEST_F(Probe, MissesXvfb) {
    environment_.set("PATH", "/nonexistent");
    expect_missing(before_, {"hlsl-fxc"}, "is missing", "apt-get install");
}

TEST_F(Probe, MissesTheModuleOfMetalKernels) {
    environment_.set("LACQUER_SHARE", share_folder().string());
    const fs::path program = folder_ / "backends_probe";
    fs::copy_file(BACKENDS_PROBE, program);
    const Reports alone = probe_all(program);
    EXPECT_FALSE(alone.at("msl").usable);
    EXPECT_THAT(alone.at("msl").detail, HasSubstr("lacquer_msl.so"));
    EXPECT_THAT(alone.at("msl").remedy, HasSubstr("lacquer_msl"));
}

// libvulkan itself cannot be hidden from wgpu, which has a way of its own to find it.
TEST_F(Probe, MissesTheVulkanLoader) {
    break_library("libvulkan.so");
    break_library("libvulkan.so.1");
    const Reports alone = probe_all();
    for (const char* name : {"vulkan", "hlsl"}) {
        EXPECT_FALSE(alone.at(name).usable);
        EXPECT_THAT(alone.at(name).detail, HasSubstr("libvulkan.so.1"));
        EXPECT_THAT(alone.at(name).remedy, HasSubstr("apt-get install libvulkan1"));
    }
}

}  // namespace
}  // namespace lacquer::test
