// A job on the processor's cores: the kernels of shader_src/kernels as loops.
#pragma once

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <chrono>
#include <vector>

#include "backends/backend.h"
#include "core/error.h"

namespace lacquer {

// One query of `kernel`, from its input rows to its result rows. Surface has the members of
// Bsdf<Real>: eval, eval_cos, pdf, sample and albedo.
template <typename Real, typename Surface>
void run_query(Kernel kernel, const Surface& surface, const KernelParameters& parameters,
               const glm::vec4* inputs, glm::dvec4* results) {
    using Vector = glm::vec<3, Real>;
    const auto input = [&](std::size_t row) { return Vector{inputs[row]}; };
    const auto constant = [](const float(&row)[4]) { return Vector{row[0], row[1], row[2]}; };
    const auto result = [&](std::size_t row, const Vector& v, Real w) {
        results[row] = glm::dvec4{v, w};
    };
    const Real zero{0};
    switch (kernel) {
        case Kernel::eval:
            result(0, surface.eval(input(0), input(1)), surface.pdf(input(0), input(1)));
            break;
        case Kernel::slice: {
            const Vector wo = constant(parameters.wo);
            result(0, surface.eval(input(0), wo), surface.pdf(input(0), wo));
            break;
        }
        case Kernel::sphere:
            result(0, constant(parameters.radiance) * surface.eval_cos(input(0), input(1)),
                   Real{1});
            break;
        case Kernel::sample: {
            const auto chosen = surface.sample(input(0), input(1));
            result(0, chosen.wi, chosen.pdf);
            result(1, chosen.weight, zero);
            break;
        }
        case Kernel::albedo: {
            const auto albedo = surface.albedo(input(0), static_cast<int>(parameters.point_count));
            result(0, albedo.direct, zero);
            result(1, albedo.base, zero);
            result(2, albedo.transmitted, zero);
            break;
        }
        case Kernel::copy:
            results[0] = glm::dvec4{glm::vec<4, Real>{inputs[0]} + glm::vec<4, Real>{inputs[1]}};
            break;
        case Kernel::lights:  // run_lights
        case Kernel::walk:
        case Kernel::walk_exits:
        case Kernel::walk_orders:
        case Kernel::walk_conductors:
        case Kernel::walk_mirror_lobe:
            throw Error{fmt::format("kernel '{}': no model has it; the simulator is its judge",
                                    kernel_shape(kernel).name)};
    }
}

// Runs `run_one(query, inputs, results)` for every query of a job, on all cores.
template <typename RunOne>
JobResult run_queries(const Job& job, const RunOne& run_one) {
    const KernelShape shape = kernel_shape(job.kernel);
    JobResult result;
    result.rows.resize(job.query_count() * shape.result_rows);
    const auto start = std::chrono::steady_clock::now();
    tbb::parallel_for(std::uint64_t{0}, job.query_count(), [&](std::uint64_t query) {
        run_one(query, &job.inputs[query * shape.input_rows],
                &result.rows[query * shape.result_rows]);
    });
    result.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

template <typename Prepare>
auto all_prepared(const Job& job, const Prepare& prepare) {
    std::vector<decltype(prepare(job.materials[0]))> surfaces;
    surfaces.reserve(job.materials.size());
    for (const Material& material : job.materials) surfaces.push_back(prepare(material));
    return surfaces;
}

// The kernel `lights` (Surface also has `view`), which unlike the others reads the rows of other
// queries, and whose preparing is part of what it measures: but for what a model finds out once per
// material, which every other backend is given too.
template <typename Real, typename Prepare>
JobResult run_lights(const Job& job, const Prepare& prepare) {
    const std::uint64_t query_count = job.query_count();
    const auto surfaces = job.model == Model::microsurface_compensated
                              ? all_prepared(job, prepare)
                              : std::vector<decltype(prepare(job.materials[0]))>{};
    return run_queries(job, [&](std::uint64_t query, const glm::vec4* inputs, glm::dvec4* results) {
        using Vector = glm::vec<3, Real>;
        const std::uint64_t material = query / job.queries_per_material;
        const auto surface =
            surfaces.empty() ? prepare(job.materials[material]) : surfaces[material];
        const auto view = surface.view(Vector{*inputs});
        Vector sum{0};
        for (std::uint64_t n = 1; n <= job.parameters.point_count; ++n)
            sum += view.eval_cos(Vector{job.inputs[(query + n) % query_count]});
        *results = glm::dvec4{sum, 1.0};
    });
}

// Runs a whole job with the surfaces that `prepare(material)` makes.
template <typename Real, typename Prepare>
JobResult run_on_cpu(const Job& job, const Prepare& prepare) {
    check_job(job);
    if (job.kernel == Kernel::lights) return run_lights<Real>(job, prepare);
    const auto surfaces = all_prepared(job, prepare);
    return run_queries(job, [&](std::uint64_t query, const glm::vec4* inputs, glm::dvec4* results) {
        run_query<Real>(job.kernel, surfaces[query / job.queries_per_material], job.parameters,
                        inputs, results);
    });
}

}  // namespace lacquer
