// Backend `reference`: the models in double precision, which every other backend is measured
// against.
#include "reference/models.h"

#include "backends/cpu_job.h"
#include "backends/entries.h"
#include "material/numbers.h"

namespace lacquer {

namespace {

constexpr const char* kDevice = "double precision, all cores";

struct ReferenceView;

// The reference under the member names that run_query calls.
struct ReferenceSurface {
    using Vector = glm::dvec3;
    std::shared_ptr<const reference::Shading> shading;

    Vector eval(const Vector& wi, const Vector& wo) const { return shading->eval(wi, wo); }
    Vector eval_cos(const Vector& wi, const Vector& wo) const {
        return eval(wi, wo) * std::abs(wi.z);
    }
    ReferenceView view(const Vector& wo) const;
    double pdf(const Vector& wi, const Vector& wo) const { return shading->pdf(wi, wo); }
    reference::Sample sample(const Vector& wo, const Vector& u) const {
        return shading->sample(wo, u);
    }
    reference::Albedo albedo(const Vector& wo, int) const { return shading->albedo(wo); }
};

// A viewer of it, as run_lights asks for.
struct ReferenceView {
    const ReferenceSurface* surface;
    glm::dvec3 wo;

    glm::dvec3 eval_cos(const glm::dvec3& wi) const { return surface->eval_cos(wi, wo); }
};

ReferenceView ReferenceSurface::view(const glm::dvec3& wo) const {
    return {this, wo};
}

// It shades the material as the other backends read it: rounded to float, like its directions.
class ReferenceBackend final : public Backend {
 public:
    void prepare(Model, Kernel) override {}

    JobResult run(const Job& job) override {
        return run_on_cpu<double>(job, [&](const Material& material) {
            return ReferenceSurface{reference::prepare(as_shaders_read(material), job.model)};
        });
    }

    std::string device() const override { return kDevice; }
};

}  // namespace

constinit const BackendEntry kReferenceEntry{
    "reference", "the models in double precision, from the papers and textbooks",
    [](const BackendOptions&) {
        return Availability{true, kDevice, ""};
    },
    [](const BackendOptions&) -> std::unique_ptr<Backend> {
        return std::make_unique<ReferenceBackend>();
    }};

}  // namespace lacquer
