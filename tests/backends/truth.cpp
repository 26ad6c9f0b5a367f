#include "backends/truth.h"

#include <glm/vec3.hpp>

#include "lacquer/bsdf.h"
#include "material/numbers.h"

namespace lacquer::test {

namespace {

using Rows = std::vector<glm::dvec4>;

glm::dvec3 vector(const glm::vec4& row) {
    return {row.x, row.y, row.z};
}

glm::dvec3 vector(const float (&row)[4]) {
    return {row[0], row[1], row[2]};
}

void append_rows(const Job& job, const Bsdf<double>& bsdf, const glm::vec4* inputs, Rows& rows) {
    const glm::dvec3 first = vector(inputs[0]);
    switch (job.kernel) {
        case Kernel::eval: {
            const glm::dvec3 wo = vector(inputs[1]);
            rows.emplace_back(bsdf.eval(first, wo), bsdf.pdf(first, wo));
            break;
        }
        case Kernel::slice: {
            const glm::dvec3 wo = vector(job.parameters.wo);
            rows.emplace_back(bsdf.eval(first, wo), bsdf.pdf(first, wo));
            break;
        }
        case Kernel::sphere:
            rows.emplace_back(
                vector(job.parameters.radiance) * bsdf.eval_cos(first, vector(inputs[1])), 1.0);
            break;
        case Kernel::sample: {
            const BsdfSample<double> chosen = bsdf.sample(first, vector(inputs[1]));
            rows.emplace_back(chosen.wi, chosen.pdf);
            rows.emplace_back(chosen.weight, 0.0);
            break;
        }
        case Kernel::albedo: {
            const DirectionalAlbedo<double> albedo =
                bsdf.albedo(first, static_cast<int>(job.parameters.point_count));
            rows.emplace_back(albedo.direct, 0.0);
            rows.emplace_back(albedo.base, 0.0);
            break;
        }
        case Kernel::copy:
            rows.emplace_back(glm::dvec4{inputs[0]} + glm::dvec4{inputs[1]});
            break;
    }
}

std::vector<Bsdf<double>> bsdfs_of(const Job& job) {
    std::vector<Bsdf<double>> bsdfs;
    for (const Material& material : job.materials)
        bsdfs.push_back(prepare<double>(rounded_to_float(material), job.model));
    return bsdfs;
}

}  // namespace

Rows expected_rows(const Job& job) {
    const std::vector<Bsdf<double>> bsdfs = bsdfs_of(job);
    const std::uint32_t stride = kernel_shape(job.kernel).input_rows;
    Rows rows;
    for (std::uint64_t query = 0; query < job.query_count(); ++query)
        append_rows(job, bsdfs[query / job.queries_per_material], &job.inputs[query * stride],
                    rows);
    return rows;
}

Rows expected_at_samples(const Job& job, const Rows& rows) {
    const std::vector<Bsdf<double>> bsdfs = bsdfs_of(job);
    Rows expected;
    for (std::uint64_t query = 0; query < job.query_count(); ++query) {
        const Bsdf<double>& bsdf = bsdfs[query / job.queries_per_material];
        const glm::dvec3 wi{rows[2 * query]};
        const glm::dvec3 wo = vector(job.inputs[2 * query]);
        const double pdf = bsdf.pdf(wi, wo);
        expected.emplace_back(wi, pdf);
        expected.emplace_back(pdf > 0.0 ? bsdf.eval_cos(wi, wo) / pdf : glm::dvec3{0.0}, 0.0);
    }
    return expected;
}

}  // namespace lacquer::test
