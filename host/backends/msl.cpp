// Backend `msl`: the generated Metal compiled as C++ when the project was built
// (host/backends/msl), on the processor's cores.
#include <dlfcn.h>
#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <map>
#include <memory>

#include "backends/entries.h"
#include "backends/float_backend.h"
#include "backends/shader_store.h"
#include "core/error.h"
#include "core/paths.h"

namespace lacquer {

namespace {

constexpr const char* kDevice = "C++ shim, " LACQUER_COMPILER;

// Runs the threads [first, end) of a kernel over buffers by their bindings.
using MslKernel = void (*)(void* const* buffers, unsigned first, unsigned end);

struct CloseModule {
    void operator()(void* module) const { dlclose(module); }
};
using Module = std::unique_ptr<void, CloseModule>;

Module load_module() {
    const std::filesystem::path file = module_folder() / "lacquer_msl.so";
    Module module{dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL)};
    if (!module)
        throw Unavailable{
            fmt::format("the compiled Metal kernels cannot be loaded ({})", dlerror()),
            "build and install the target lacquer_msl"};
    return module;
}

class MslBackend final : public FloatBackend {
 public:
    std::string device() const override { return kDevice; }

 private:
    void compile(Model model, Kernel kernel) override {
        const std::string name = fmt::format("lacquer_msl_{}_{}", kernel_level(model, kernel),
                                             kernel_shape(kernel).name);
        void* const symbol = dlsym(module_.get(), name.c_str());
        if (symbol == nullptr) throw Error{fmt::format("the Metal kernels lack '{}'", name)};
        kernels_[{model, kernel}] = reinterpret_cast<MslKernel>(symbol);
    }

    std::optional<double> execute(const Dispatch& dispatch, std::span<glm::vec4> results) override {
        std::array<void*, 5> buffers{};
        const auto arguments = kernel_arguments(dispatch, results);
        for (std::size_t binding = 0; binding < arguments.size(); ++binding) {
            const BufferArgument& argument = arguments[binding];
            // A kernel gets reading buffers as references to const.
            buffers[binding] = argument.kind == BufferArgument::Kind::write
                                   ? argument.results.data()
                                   : const_cast<std::byte*>(argument.bytes.data());
        }
        const MslKernel kernel = kernels_.at({dispatch.model, dispatch.kernel});
        tbb::parallel_for(tbb::blocked_range<unsigned>{0, dispatch.parameters.query_count},
                          [&](const tbb::blocked_range<unsigned>& range) {
                              kernel(buffers.data(), range.begin(), range.end());
                          });
        return std::nullopt;
    }

    Module module_ = load_module();
    std::map<std::pair<Model, Kernel>, MslKernel> kernels_;
};

}  // namespace

constinit const BackendEntry kMslEntry{"msl", "Metal compiled as C++",
                                       [](const BackendOptions&) {
                                           return probe_by_trying([] {
                                               load_module();
                                               return std::string{kDevice};
                                           });
                                       },
                                       [](const BackendOptions&) -> std::unique_ptr<Backend> {
                                           return std::make_unique<MslBackend>();
                                       }};

}  // namespace lacquer
