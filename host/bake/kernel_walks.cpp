#include "bake/kernel_walks.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lacquer::bake {

namespace {

// Walks of a query that sums them up. Mesa's software renderers silently end a shader's loops after
// 65535 iterations in all, and a walk may take LQ_MAX_WALK_FACETS = 1024; few also keep the
// rounding of the sums, which are floats, below any noise.
constexpr std::uint32_t kWalksPerSum = 32;

// Queries of one job, which bound the memory of its rows.
constexpr std::size_t kQueriesPerJob = std::size_t{1} << 17;

std::size_t quotient_above(std::size_t dividend, std::size_t divisor) {
    return (dividend + divisor - 1) / divisor;
}

float uint24(std::uint64_t bits) {
    return static_cast<float>(bits & 0xffffff);
}

// The rows that every kernel reads first: shader_src/kernels/walk_queries.glsl.
void write_stream(std::span<glm::vec4> rows, const glm::dvec3& boundary, std::uint64_t seed,
                  std::size_t first_walk) {
    const std::uint64_t bits = mix_bits(seed);
    rows[0] = glm::vec4{boundary, static_cast<float>(first_walk)};
    rows[1] = {uint24(bits), uint24(bits >> 24), 0.0f, 0.0f};
}

}  // namespace

KernelWalks::KernelWalks(std::string name, std::unique_ptr<Backend> backend, std::size_t samples)
    : name_{std::move(name)}, backend_{std::move(backend)}, samples_{samples} {}

void KernelWalks::run(
    Kernel kernel, std::size_t count,
    const std::function<void(std::size_t, std::span<glm::vec4>)>& inputs,
    const std::function<void(std::size_t, std::span<const glm::dvec4>)>& take) const {
    const KernelShape shape = kernel_shape(kernel);
    const Material ignored;  // these kernels shade none
    std::vector<glm::vec4> rows;
    for (std::size_t begin = 0; begin < count; begin += kQueriesPerJob) {
        const std::size_t size = std::min(kQueriesPerJob, count - begin);
        rows.resize(size * shape.input_rows);
        for (std::size_t n = 0; n < size; ++n)
            inputs(begin + n, std::span{rows}.subspan(n * shape.input_rows, shape.input_rows));
        Job job;
        job.kernel = kernel;
        job.materials = {&ignored, 1};
        job.queries_per_material = size;
        job.inputs = rows;
        job.parameters.point_count = kWalksPerSum;
        const JobResult result = backend_->run(job);
        for (std::size_t n = 0; n < size; ++n)
            take(begin + n,
                 std::span{result.rows}.subspan(n * shape.result_rows, shape.result_rows));
    }
}

std::vector<CosineHistogram> KernelWalks::light_entering(std::span<const double> cosines,
                                                         double alpha, double eta,
                                                         std::uint64_t seed) const {
    // On a smooth interface all walks are the same.
    const std::size_t queries = alpha > 0.0 ? quotient_above(samples_, kWalksPerExitQuery) : 1;
    std::vector<CosineHistogram> entered(cosines.size());
    run(
        Kernel::walk_exits, queries * cosines.size(),
        [&](std::size_t query, std::span<glm::vec4> rows) {
            const std::size_t n = query / queries;
            write_stream(rows, {alpha, eta, cosines[n]}, seed + n,
                         query % queries * kWalksPerExitQuery);
        },
        [&](std::size_t query, std::span<const glm::dvec4> exits) {
            for (const glm::dvec4& exit : exits) entered[query / queries].add(exit.y, exit.x);
        });
    for (CosineHistogram& each : entered)
        each.scale(1.0 / static_cast<double>(queries * kWalksPerExitQuery));
    return entered;
}

DiffuseExits KernelWalks::light_leaving(double alpha, double eta, std::uint64_t seed) const {
    // Queries share the cosine-weighted hemisphere in strata of equal light.
    const std::size_t queries = quotient_above(samples_, kWalksPerExitQuery);
    const auto cosine = [&](std::size_t query) {
        const double jitter = static_cast<double>(mix_bits(seed ^ (query + 1)) >> 12) * 0x1p-52;
        return std::sqrt((static_cast<double>(query) + jitter) / static_cast<double>(queries));
    };
    DiffuseExits exits;
    run(
        Kernel::walk_exits, queries,
        [&](std::size_t query, std::span<glm::vec4> rows) {
            // Turned over, the light comes from above and the index is inverted.
            write_stream(rows, {alpha, 1.0 / eta, cosine(query)}, seed, query * kWalksPerExitQuery);
        },
        [&](std::size_t query, std::span<const glm::dvec4> results) {
            for (const glm::dvec4& exit : results) {
                exits.left.add(cosine(query), exit.x);
                if (exit.z > 0.0)
                    exits.reflected.add(2.0 / (1.0 / cosine(query) + 1.0 / exit.w), exit.z);
            }
        });
    const double share = 1.0 / static_cast<double>(queries * kWalksPerExitQuery);
    exits.left.scale(share);
    exits.reflected.scale(share);
    return exits;
}

std::vector<double> KernelWalks::reflected_by_conductors(double cos_theta, double alpha,
                                                         const Conductors& conductors,
                                                         std::uint64_t seed) const {
    constexpr std::size_t kAtOnce = 3;
    const auto& indices = conductors.indices;
    const std::size_t triples = quotient_above(indices.size(), kAtOnce);
    const std::size_t blocks = alpha > 0.0 ? quotient_above(samples_, kWalksPerSum) : 1;
    // The last triple is filled up with the last conductor.
    const auto index_of = [&](std::size_t triple, std::size_t n) {
        return indices[std::min(triple * kAtOnce + n, indices.size() - 1)];
    };
    std::vector<double> reflected(triples * kAtOnce, 0.0);
    run(
        Kernel::walk_conductors, triples * blocks,
        [&](std::size_t query, std::span<glm::vec4> rows) {
            // All conductors are met by the same walks, which keeps their differences quiet.
            write_stream(rows, {alpha, 1.0, cos_theta}, seed, query / triples * kWalksPerSum);
            for (std::size_t n = 0; n < kAtOnce; ++n) {
                const auto component = static_cast<glm::length_t>(n);
                const Conductors::Index index = index_of(query % triples, n);
                rows[2][component] = static_cast<float>(index.eta);
                rows[3][component] = static_cast<float>(index.kappa);
            }
        },
        [&](std::size_t query, std::span<const glm::dvec4> sums) {
            for (std::size_t n = 0; n < kAtOnce; ++n)
                reflected[query % triples * kAtOnce + n] +=
                    sums[0][static_cast<glm::length_t>(n)] /
                    static_cast<double>(blocks * kWalksPerSum);
        });
    reflected.resize(indices.size());
    return reflected;
}

std::vector<glm::dvec3> KernelWalks::means(Kernel kernel, std::span<const double> cosines,
                                           double alpha, double eta, std::uint64_t seed) const {
    const std::size_t queries = alpha > 0.0 ? quotient_above(samples_, kWalksPerSum) : 1;
    std::vector<glm::dvec3> averages(cosines.size(), glm::dvec3{0.0});
    run(
        kernel, queries * cosines.size(),
        [&](std::size_t query, std::span<glm::vec4> rows) {
            const std::size_t n = query / queries;
            write_stream(rows, {alpha, eta, cosines[n]}, seed + n, query % queries * kWalksPerSum);
        },
        [&](std::size_t query, std::span<const glm::dvec4> rows) {
            averages[query / queries] +=
                glm::dvec3{rows[0]} / static_cast<double>(queries * kWalksPerSum);
        });
    return averages;
}

std::vector<double> KernelWalks::light_reflected_again(std::span<const double> cosines,
                                                       double alpha, double eta,
                                                       std::uint64_t seed) const {
    std::vector<double> reflected;
    for (const glm::dvec3& mean : means(Kernel::walk_orders, cosines, alpha, eta, seed))
        reflected.push_back(mean.z);
    return reflected;
}

double KernelWalks::reflected_once(double cos_theta, double alpha, std::uint64_t seed) const {
    return means(Kernel::walk_mirror_lobe, {&cos_theta, 1}, alpha, 1.0, seed).front().x;
}

std::vector<double> KernelWalks::lobe_transmittances(std::span<const double> cosines, double alpha,
                                                     double eta, std::uint64_t seed) const {
    std::vector<double> transmittances;
    for (const glm::dvec3& mean : means(Kernel::walk_mirror_lobe, cosines, alpha, eta, seed))
        transmittances.push_back(mean.x > 0.0 ? mean.y / mean.x : 0.0);
    return transmittances;
}

}  // namespace lacquer::bake
