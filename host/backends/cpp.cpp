// Backend `cpp`: the shader source compiled as C++ in float, as C++ renderers link it.
#include "backends/cpu_job.h"
#include "backends/entries.h"
#include "lacquer/bsdf.h"
#include "shading/interface_walk.h"

namespace lacquer {

namespace {

std::string compiler() {
    return "g++ " + std::string{__VERSION__} + ", all cores";
}

JobResult run_walks(const Job& job) {
    check_job(job);
    return run_queries(job, [&](std::uint64_t, const glm::vec4* inputs, glm::dvec4* results) {
        const InterfaceSums sums =
            walk_interface(inputs[0], inputs[1].x, job.parameters.point_count);
        results[0] = sums.energies;
        results[1] = sums.squares;
        results[2] = sums.spread;
    });
}

class CppBackend final : public Backend {
 public:
    void prepare(Model, Kernel) override {}

    JobResult run(const Job& job) override {
        if (job.kernel == Kernel::walk) return run_walks(job);
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
