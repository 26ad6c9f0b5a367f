#include "backends/truth.h"

#include <glm/vec3.hpp>

#include "backends/jobs.h"
#include "lacquer/bsdf.h"
#include "material/numbers.h"

namespace lacquer::test {

namespace {

Rows reference_rows(const Job& job) {
    return backend_from_name("reference").create({})->run(job).rows;
}

Rows expected_samples(const Job& job, const Rows& rows) {
    OwnedJob at_samples{Kernel::eval,
                        {job.materials.begin(), job.materials.end()},
                        job.queries_per_material,
                        {},
                        {},
                        job.model};
    for (std::size_t query = 0; query < job.query_count(); ++query) {
        at_samples.inputs.emplace_back(glm::vec3{rows[2 * query]}, 0.0f);
        at_samples.inputs.push_back(job.inputs[2 * query]);
    }
    const Rows evaluated = reference_rows(at_samples.job());
    at_samples.kernel = Kernel::sphere;  // times cos_theta_i
    const Rows lit = reference_rows(at_samples.job());
    const Rows chosen = reference_rows(job);
    Rows expected;
    for (std::size_t query = 0; query < job.query_count(); ++query) {
        // A lobe may choose a direction on the other side of the surface, where it has no light
        // but another lobe has: such a sample is lost, for the reference too.
        const bool is_lost = rows[2 * query].w == 0.0 && chosen[2 * query].w == 0.0;
        const double pdf = is_lost ? 0.0 : evaluated[query].w;
        const glm::dvec3 weight{lit[query]};
        expected.emplace_back(glm::dvec3{rows[2 * query]}, pdf);
        expected.emplace_back(pdf > 0.0 ? weight / pdf : glm::dvec3{0.0}, 0.0);
    }
    return expected;
}

Rows expected_albedos(const Job& job) {
    Rows expected;
    const int point_count = static_cast<int>(job.parameters.point_count);
    std::vector<Bsdf<double>> surfaces;
    for (const Material& material : job.materials)
        surfaces.push_back(prepare<double>(as_shaders_read(material), job.model));
    for (std::size_t query = 0; query < job.query_count(); ++query) {
        const DirectionalAlbedo<double> albedo = surfaces[query / job.queries_per_material].albedo(
            glm::dvec3{job.inputs[query]}, point_count);
        expected.emplace_back(albedo.direct, 0.0);
        expected.emplace_back(albedo.base, 0.0);
        expected.emplace_back(albedo.transmitted, 0.0);
    }
    return expected;
}

}  // namespace

Rows expected_rows(const Job& job, const Rows& rows) {
    switch (job.kernel) {
        case Kernel::sample:
            return expected_samples(job, rows);
        case Kernel::albedo:
            return expected_albedos(job);
        default:
            return reference_rows(job);
    }
}

}  // namespace lacquer::test
