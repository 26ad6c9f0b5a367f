// Backends `wgsl-wgpu` and `wgsl-dawn`: the generated WGSL in two implementations of WebGPU.
#include <fmt/format.h>

#include <memory>

#include "backends/entries.h"
#include "backends/float_backend.h"
#include "backends/shader_store.h"
#include "backends/webgpu_process.h"
#include "core/environment.h"
#include "core/error.h"
#include "core/paths.h"
#include "vulkan/driver.h"

namespace lacquer {

namespace fs = std::filesystem;

namespace {

constexpr const char* kSwiftShaderManifest = "/usr/lib/chromium/vk_swiftshader_icd.json";

fs::path runner_folder() {
    return share_folder() / "node" / "webgpu";
}

// The processor as npm packages name it.
std::string_view npm_architecture() {
#if defined(__aarch64__)
    return "arm64";
#else
    return "x64";
#endif
}

// A file that an npm package brings.
fs::path require_package_file(const fs::path& relative) {
    const fs::path file = runner_folder() / "node_modules" / relative;
    if (!fs::exists(file))
        throw Unavailable{fmt::format("'{}' is missing", file.string()),
                          fmt::format("npm ci --ignore-scripts --prefix '{}'",
                                      fs::weakly_canonical(runner_folder()).string())};
    return file;
}

// wgpu in Deno, on lavapipe or the Vulkan driver that the user chose.
std::unique_ptr<WebgpuProcess> start_wgpu() {
    const fs::path deno =
        require_package_file(fmt::format("@deno/linux-{}-glibc/deno", npm_architecture()));
    ScopedEnvironment environment;
    vulkan::show_default_driver(environment);
    environment.set("DENO_NO_UPDATE_CHECK", "1");
    environment.set("DENO_WEBGPU_BACKEND", "vulkan");  // or it would make do with OpenGL
    const WebgpuProgram program{
        deno,
        {"run", "--unstable-webgpu", "--no-config", "--no-lock", "--no-remote", "--no-npm",
         "--no-prompt", (runner_folder() / "runner.mjs").string()}};
    try {
        return std::make_unique<WebgpuProcess>(program);
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
std::unique_ptr<WebgpuProcess> start_dawn() {
    const auto node = node_program();
    if (!node) throw Unavailable{"Node.js is missing", node_missing_message()};
    require_package_file(fmt::format("webgpu/dist/linux-{}/dawn.node", npm_architecture()));
    ScopedEnvironment environment;
    vulkan::show_driver(environment, swiftshader_manifest());
    return std::make_unique<WebgpuProcess>(
        WebgpuProgram{*node, {(runner_folder() / "runner.mjs").string()}});
}

using Start = std::unique_ptr<WebgpuProcess> (*)();

class WebgpuBackend final : public FloatBackend {
 public:
    explicit WebgpuBackend(std::unique_ptr<WebgpuProcess> process) : process_{std::move(process)} {}

    std::string device() const override { return process_->adapter(); }

 private:
    static std::string name_of(Model model, Kernel kernel) {
        return fmt::format("{}_{}", model_name(model), kernel_shape(kernel).name);
    }

    void compile(Model model, Kernel kernel) override {
        const ShaderSource source = load_shader("wgsl", model, kernel);
        process_->compile(name_of(model, kernel), source.contents, source.entry_point,
                          kernel_argument_kinds());
    }

    std::optional<double> execute(const Dispatch& dispatch, std::span<glm::vec4> results) override {
        process_->run(name_of(dispatch.model, dispatch.kernel), kernel_arguments(dispatch, results),
                      dispatch.workgroups());
        return std::nullopt;
    }

    std::unique_ptr<WebgpuProcess> process_;
};

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
    return std::make_unique<WebgpuBackend>(start());
}

}  // namespace

constinit const BackendEntry kWgpuEntry{"wgsl-wgpu", "WGSL on wgpu (Deno)", probe<start_wgpu>,
                                        create<start_wgpu>};
constinit const BackendEntry kDawnEntry{"wgsl-dawn", "WGSL on Dawn (Node) and SwiftShader",
                                        probe<start_dawn>, create<start_dawn>};

}  // namespace lacquer
