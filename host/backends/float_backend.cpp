#include "backends/float_backend.h"

#include <algorithm>
#include <chrono>

#include "backends/pack.h"
#include "tables/texels.h"

namespace lacquer {

namespace {

// Consecutive queries of a job that share a dispatch: whole materials, or a part of one.
struct Part {
    std::uint64_t first_query = 0;
    std::uint64_t query_count = 0;
    std::uint64_t first_material = 0;
    std::uint64_t material_count = 0;
};

std::vector<Part> split(const Job& job) {
    std::vector<Part> parts;
    const std::uint64_t per_material = job.queries_per_material;
    const std::uint64_t materials_at_once =
        std::max<std::uint64_t>(1, kMaxDispatchQueries / per_material);
    for (std::uint64_t material = 0; material < job.materials.size();
         material += materials_at_once) {
        const std::uint64_t material_count =
            std::min<std::uint64_t>(materials_at_once, job.materials.size() - material);
        const std::uint64_t end = (material + material_count) * per_material;
        for (std::uint64_t query = material * per_material; query < end;
             query += kMaxDispatchQueries)
            parts.push_back(
                {query, std::min(kMaxDispatchQueries, end - query), material, material_count});
    }
    return parts;
}

Dispatch dispatch_of(const Job& job, const Part& part, std::span<const glm::vec4> surfaces) {
    const KernelShape shape = kernel_shape(job.kernel);
    Dispatch dispatch{job.model, job.kernel, surfaces,
                      job.inputs.subspan(part.first_query * shape.input_rows,
                                         part.query_count * shape.input_rows),
                      job.parameters};
    dispatch.parameters.query_count = static_cast<std::uint32_t>(part.query_count);
    dispatch.parameters.queries_per_surface =
        static_cast<std::uint32_t>(std::min(job.queries_per_material, kMaxDispatchQueries));
    return dispatch;
}

// A buffer of no bytes cannot be bound: a model that reads no tables gets one texel.
std::span<const TableTexel> tables_of(Model model) {
    static const TableTexel none{0};
    return reads_tables(model) ? shipped_texels() : std::span{&none, 1};
}

}  // namespace

std::uint32_t Dispatch::workgroups() const {
    return (parameters.query_count + kWorkgroupSize - 1) / kWorkgroupSize;
}

std::array<BufferArgument, 5> kernel_arguments(const Dispatch& dispatch,
                                               std::span<glm::vec4> results) {
    using Kind = BufferArgument::Kind;
    return {BufferArgument{Kind::uniform, std::as_bytes(std::span{&dispatch.parameters, 1}), {}},
            BufferArgument{Kind::read, std::as_bytes(dispatch.surfaces), {}},
            BufferArgument{Kind::read, std::as_bytes(dispatch.inputs), {}},
            BufferArgument{Kind::write, {}, std::as_writable_bytes(results)},
            BufferArgument{Kind::read, std::as_bytes(tables_of(dispatch.model)), {}}};
}

std::vector<BufferArgument::Kind> kernel_argument_kinds() {
    using Kind = BufferArgument::Kind;
    return {Kind::uniform, Kind::read, Kind::read, Kind::write, Kind::read};
}

void FloatBackend::prepare(Model model, Kernel kernel) {
    if (prepared_.contains({model, kernel})) return;
    compile(model, kernel);
    // Drivers translate to machine code when a kernel first runs: let that be now. One query over
    // zeroed rows, which every kernel must bear.
    const KernelShape shape = kernel_shape(kernel);
    const std::vector<glm::vec4> surfaces(surface_rows(model));
    const std::vector<glm::vec4> inputs(shape.input_rows);
    std::vector<glm::vec4> results(shape.result_rows);
    Dispatch dispatch{model, kernel, surfaces, inputs, {}};
    dispatch.parameters.query_count = 1;
    execute(dispatch, results);
    prepared_.insert({model, kernel});
}

JobResult FloatBackend::run(const Job& job) {
    check_job(job);
    const std::vector<glm::vec4> surfaces = pack_surfaces(job.model, job.materials);
    prepare(job.model, job.kernel);

    const std::size_t rows = surface_rows(job.model);
    const std::uint32_t result_rows = kernel_shape(job.kernel).result_rows;
    JobResult result;
    result.rows.reserve(job.query_count() * result_rows);
    std::vector<glm::vec4> part_rows;
    for (const Part& part : split(job)) {
        const Dispatch dispatch = dispatch_of(
            job, part,
            std::span{surfaces}.subspan(part.first_material * rows, part.material_count * rows));
        part_rows.resize(part.query_count * result_rows);
        const auto start = std::chrono::steady_clock::now();
        const auto device_seconds = execute(dispatch, part_rows);
        result.seconds +=
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        if (device_seconds)
            result.device_seconds = result.device_seconds.value_or(0.0) + *device_seconds;
        result.rows.insert(result.rows.end(), part_rows.begin(), part_rows.end());
    }
    return result;
}

}  // namespace lacquer
