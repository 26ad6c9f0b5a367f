// Backend `hlsl-fxc`: the generated HLSL through Microsoft's own compilers under Wine. FXC's
// bytecode runs on Direct3D 11; DXC, whose bytecode Wine cannot run, only checks shader model 6.0.
#include <fmt/format.h>

#include "backends/entries.h"
#include "backends/node_packages.h"
#include "backends/runner_kernels.h"
#include "backends/shader_store.h"
#include "backends/virtual_display.h"
#include "core/environment.h"
#include "core/error.h"
#include "core/paths.h"
#include "core/process.h"

namespace lacquer {

namespace fs = std::filesystem;

namespace {

constexpr const char* kDevice = "FXC, Direct3D 11 on Wine";

// Microsoft's compilers come with the npm package `webgpu`.
constexpr const char* kCompilerFolder = "webgpu/dist/win32-x64";

fs::path require_wine() {
    if (const auto wine = find_wine()) return *wine;
    throw Unavailable{"Wine is missing", "apt-get install wine64"};
}

fs::path require_program() {
    const fs::path program = module_folder() / "lacquer-fxc.exe";
    if (!fs::exists(program))
        throw Unavailable{fmt::format("'{}' was not built", program.string()),
                          "apt-get install g++-mingw-w64-x86-64-win32, then build again"};
    return program;
}

// The folder of Microsoft's compilers as Wine names it.
std::string require_compilers() {
    require_package_file(fs::path{kCompilerFolder} / "dxcompiler.dll");
    const fs::path fxc = require_package_file(fs::path{kCompilerFolder} / "d3dcompiler_47.dll");
    std::string folder = "Z:" + fs::weakly_canonical(fxc.parent_path()).string();
    std::replace(folder.begin(), folder.end(), '/', '\\');
    return folder;
}

// Where Wine keeps its Windows: made when first used, 700 MB.
fs::path wine_prefix() {
    if (const auto chosen = environment_variable("WINEPREFIX")) return *chosen;
    fs::path cache = fs::temp_directory_path();
    if (const auto home = environment_variable("HOME")) cache = fs::path{*home} / ".cache";
    if (const auto chosen = environment_variable("XDG_CACHE_HOME")) cache = *chosen;
    fs::create_directories(cache / "lacquer");
    return cache / "lacquer" / "wine";
}

std::unique_ptr<RunnerProcess> start(const std::string& display) {
    const RunnerProgram program{require_wine(), {require_program().string(), require_compilers()}};
    ScopedEnvironment environment;
    environment.set("WINEPREFIX", wine_prefix().string());
    environment.set("WINEDEBUG", "-all");
    // No offers to install .NET or a browser; Microsoft's FXC instead of Wine's.
    environment.set("WINEDLLOVERRIDES", "mscoree,mshtml=;d3dcompiler_47=n");
    environment.set("DISPLAY", display);
    return std::make_unique<RunnerProcess>(program);
}

// A base class so that the display outlives the process that draws on it.
struct OwnDisplay {
    VirtualDisplay display;
};

class HlslFxcBackend final : private OwnDisplay, public RunnerKernels {
 public:
    HlslFxcBackend() : RunnerKernels{start(display.name()), "hlsl50"} {}

 private:
    void compile(Model model, Kernel kernel) override {
        RunnerKernels::compile(model, kernel);
        const ShaderSource newer = load_shader("hlsl60", model, kernel);
        process().check(newer.contents, newer.entry_point);
    }
};

}  // namespace

// Starting Wine takes seconds, and half a minute the first time: the probe only looks for the
// files.
constinit const BackendEntry kHlslFxcEntry{
    "hlsl-fxc", "HLSL 5.0 through FXC on Direct3D 11 (Wine); DXC checks HLSL 6.0",
    [](const BackendOptions&) {
        return probe_by_trying([] {
            require_wine();
            require_program();
            require_compilers();
            require_xvfb();
            return std::string{kDevice};
        });
    },
    [](const BackendOptions&) -> std::unique_ptr<Backend> {
        ensure_runtime_folder();
        return std::make_unique<HlslFxcBackend>();
    }};

}  // namespace lacquer
