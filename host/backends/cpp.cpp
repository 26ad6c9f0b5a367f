// Backend `cpp`: the shader source compiled as C++ in float, as C++ renderers link it.
#include "backends/cpu_job.h"
#include "backends/entries.h"
#include "lacquer/bsdf.h"
#include "material/numbers.h"
#include "shading/walks.h"

namespace lacquer {

namespace {

std::string compiler() {
    return "g++ " + std::string{__VERSION__} + ", all cores";
}

// The kernel's walks of one query; null for kernels that shade.
using Walk = void (*)(const glm::vec4* inputs, std::uint32_t walk_count, glm::dvec4* results);

Walk walk_of(Kernel kernel) {
    switch (kernel) {
        case Kernel::walk:
            return walk_interface;
        case Kernel::walk_exits:
            return walk_exits;
        case Kernel::walk_orders:
            return walk_orders;
        case Kernel::walk_conductors:
            return walk_conductors;
        case Kernel::walk_mirror_lobe:
            return walk_mirror_lobe;
        default:
            return nullptr;
    }
}

JobResult run_walks(const Job& job, Walk walk) {
    check_job(job);
    return run_queries(job, [&](std::uint64_t, const glm::vec4* inputs, glm::dvec4* results) {
        walk(inputs, job.parameters.point_count, results);
    });
}

class CppBackend final : public Backend {
 public:
    void prepare(Model, Kernel) override {}

    JobResult run(const Job& job) override {
        if (const Walk walk = walk_of(job.kernel)) return run_walks(job, walk);
        return run_on_cpu<float>(job, [&](const Material& material) {
            return lacquer::prepare<float>(as_shaders_read(material), job.model);
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
