// Backends `wgsl-wgpu` and `wgsl-dawn`: the generated WGSL in two implementations of WebGPU.
#include <fmt/format.h>

#include <memory>

#include "backends/entries.h"
#include "backends/node_packages.h"
#include "backends/runner_kernels.h"
#include "backends/runner_process.h"
#include "core/environment.h"
#include "core/error.h"
#include "core/paths.h"
#include "vulkan/driver.h"

namespace lacquer {

namespace fs = std::filesystem;

namespace {

constexpr const char* kSwiftShaderManifest = "/usr/lib/chromium/vk_swiftshader_icd.json";

// The processor as npm packages name it.
std::string_view npm_architecture() {
#if defined(__aarch64__)
    return "arm64";
#else
    return "x64";
#endif
}

// wgpu in Deno, on lavapipe or the Vulkan driver that the user chose.
std::unique_ptr<RunnerProcess> start_wgpu() {
    const fs::path deno =
        require_package_file(fmt::format("@deno/linux-{}-glibc/deno", npm_architecture()));
    ScopedEnvironment environment;
    vulkan::show_default_driver(environment);
    environment.set("DENO_NO_UPDATE_CHECK", "1");
    environment.set("DENO_WEBGPU_BACKEND", "vulkan");  // or it would make do with OpenGL
    const RunnerProgram program{
        deno,
        {"run", "--unstable-webgpu", "--no-config", "--no-lock", "--no-remote", "--no-npm",
         "--no-prompt", (runner_folder() / "runner.mjs").string()}};
    try {
        return std::make_unique<RunnerProcess>(program);
    } catch (const Error& error) {
        const auto choice = vulkan::users_driver_choice();
        if (!choice) throw;
        throw Unavailable{fmt::format("{} ({})", error.what(), *choice),
                          fmt::format("correct or unset {}", choice->substr(0, choice->find('=')))};
    }
}

// The driver manifest of SwiftShader: $LACQUER_SWIFTSHADER_ICD, or that of Debian's Chromium. Dawn
// asks for features that lavapipe lacks.
fs::path swiftshader_manifest() {
    const auto chosen = environment_variable("LACQUER_SWIFTSHADER_ICD");
    const fs::path manifest = chosen.value_or(kSwiftShaderManifest);
    if (!fs::exists(manifest))
        throw Unavailable{
            fmt::format("Chromium's SwiftShader is missing ('{}')", manifest.string()),
            "apt-get install chromium, or set LACQUER_SWIFTSHADER_ICD to the path of "
            "vk_swiftshader_icd.json"};
    return manifest;
}

// Dawn in Node, on SwiftShader.
std::unique_ptr<RunnerProcess> start_dawn() {
    const auto node = node_program();
    if (!node) throw Unavailable{"Node.js is missing", node_missing_message()};
    require_package_file(fmt::format("webgpu/dist/linux-{}/dawn.node", npm_architecture()));
    ScopedEnvironment environment;
    vulkan::show_driver(environment, swiftshader_manifest());
    return std::make_unique<RunnerProcess>(
        RunnerProgram{*node, {(runner_folder() / "runner.mjs").string()}});
}

using Start = std::unique_ptr<RunnerProcess> (*)();

template <Start start>
Availability probe(const BackendOptions&) {
    return probe_by_trying([] {
        ensure_runtime_folder();
        return start()->adapter();
    });
}

template <Start start>
std::unique_ptr<Backend> create(const BackendOptions&) {
    ensure_runtime_folder();
    return std::make_unique<RunnerKernels>(start(), "wgsl");
}

}  // namespace

constinit const BackendEntry kWgpuEntry{"wgsl-wgpu", "WGSL on wgpu (Deno)", probe<start_wgpu>,
                                        create<start_wgpu>};
constinit const BackendEntry kDawnEntry{"wgsl-dawn", "WGSL on Dawn (Node) and SwiftShader",
                                        probe<start_dawn>, create<start_dawn>};

}  // namespace lacquer
