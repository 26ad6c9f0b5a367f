// Backend `cpp`: the shader source compiled as C++ in float, as C++ renderers link it.
#include "backends/cpu_job.h"
#include "backends/entries.h"
#include "lacquer/bsdf.h"

namespace lacquer {

namespace {

std::string compiler() {
    return "g++ " + std::string{__VERSION__} + ", all cores";
}

class CppBackend final : public Backend {
 public:
    void prepare(Model, Kernel) override {}

    JobResult run(const Job& job) override {
        return run_on_cpu<float>(job, [&](const Material& material) {
            return lacquer::prepare<float>(material, job.model);
        });
    }

    std::string device() const override { return compiler(); }
};

}  // namespace

constinit const BackendEntry kCppEntry{"cpp", "the shader source compiled as C++, in float",
                                       [](const BackendOptions&) {
                                           return Availability{true, compiler(), ""};
                                       },
                                       [](const BackendOptions&) -> std::unique_ptr<Backend> {
                                           return std::make_unique<CppBackend>();
                                       }};

}  // namespace lacquer
