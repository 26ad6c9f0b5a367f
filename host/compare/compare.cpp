#include "compare/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <exception>

#include "core/error.h"

namespace lacquer {

namespace {

// Results of one backend: [grid], the rows of all materials one after the other.
struct Evaluation {
    std::vector<std::vector<glm::dvec4>> rows;
    double seconds = 0.0;
};

// The inputs of `grid` once for every material.
std::vector<glm::vec4> repeated_inputs(const QueryGrid& grid, std::size_t materials) {
    std::vector<glm::vec4> inputs;
    inputs.reserve(grid.inputs.size() * materials);
    for (std::size_t i = 0; i < materials; ++i)
        inputs.insert(inputs.end(), grid.inputs.begin(), grid.inputs.end());
    return inputs;
}

// All materials go into one job per grid: some executors take longer to start than to evaluate.
Evaluation evaluate(Backend& backend, const CompareRequest& request, std::string_view name) {
    std::vector<Material> materials;
    for (const NamedMaterial& named : request.materials) materials.push_back(named.material);
    Evaluation evaluation;
    for (const QueryGrid& grid : request.grids) {
        if (request.on_step) request.on_step(fmt::format("{}, {}", name, grid.name));
        backend.prepare(request.model, grid.kernel);
        const std::vector<glm::vec4> inputs = repeated_inputs(grid, materials.size());
        JobResult result = backend.run({.model = request.model,
                                        .kernel = grid.kernel,
                                        .materials = materials,
                                        .queries_per_material = grid.query_count(),
                                        .inputs = inputs,
                                        .parameters = grid.parameters});
        if (result.rows.size() != grid.query_count() * materials.size())
            throw Error{fmt::format("{} returned {} rows for {} queries", name, result.rows.size(),
                                    grid.query_count() * materials.size())};
        evaluation.seconds += result.seconds;
        evaluation.rows.push_back(std::move(result.rows));
    }
    return evaluation;
}

std::span<const glm::dvec4> rows_of(const Evaluation& evaluation, const QueryGrid& grid,
                                    std::size_t grid_index, std::size_t material) {
    return std::span{evaluation.rows[grid_index]}.subspan(material * grid.query_count(),
                                                          grid.query_count());
}

std::string component_name(Kernel kernel, int component) {
    constexpr std::array kSlice{"f_r", "f_g", "f_b", "pdf"};
    constexpr std::array kSphere{"radiance_r", "radiance_g", "radiance_b"};
    const auto index = static_cast<std::size_t>(component);
    return kernel == Kernel::sphere ? kSphere.at(index) : kSlice.at(index);
}

std::vector<glm::vec4> to_float(std::span<const glm::dvec4> rows) {
    return {rows.begin(), rows.end()};
}

std::size_t query_total(const CompareRequest& request) {
    std::size_t total = 0;
    for (const QueryGrid& grid : request.grids) total += grid.query_count();
    return total * request.materials.size();
}

double rate(std::size_t queries, double seconds) {
    return seconds > 0.0 ? double(queries) / seconds : 0.0;
}

// Where query `index` of all grids, one after the other, belongs.
struct GridPosition {
    std::size_t grid, query;
};

GridPosition locate(std::span<const QueryGrid> grids, std::size_t index) {
    std::size_t grid = 0;
    while (index >= grids[grid].query_count()) index -= grids[grid++].query_count();
    return {grid, index};
}

WorstQuery worst_query(const CompareRequest& request, const Evaluation& tested,
                       const Evaluation& reference, std::size_t material, std::size_t index,
                       int component) {
    const auto [g, query] = locate(request.grids, index);
    const QueryGrid& grid = request.grids[g];
    return {.grid = grid.name,
            .query = query_of(grid, query),
            .component = component_name(grid.kernel, component),
            .value = rows_of(tested, grid, g, material)[query][component],
            .reference = rows_of(reference, grid, g, material)[query][component]};
}

bool within(const ErrorSummary& errors, const Tolerance& tolerance) {
    return errors.non_finite == 0 && errors.max_rel <= tolerance.max_rel &&
           errors.median_rel <= tolerance.median_rel;
}

// Compares the results of one grid; appends to `errors`.
GridValues measure_grid(const QueryGrid& grid, std::span<const glm::dvec4> values,
                        std::span<const glm::dvec4> truths, std::vector<QueryError>& errors) {
    GridValues kept{.rows = to_float(values), .relative_errors = {}};
    for (std::size_t i = 0; i < values.size(); ++i) {
        errors.push_back(query_error(values[i], truths[i], compared_components(grid.kernel)));
        kept.relative_errors.push_back(static_cast<float>(errors.back().relative));
    }
    return kept;
}

MaterialResult measure(const CompareRequest& request, const Tolerance& tolerance,
                       const Evaluation& tested, const Evaluation& reference,
                       std::size_t material) {
    MaterialResult result;
    result.name = request.materials[material].name;
    std::vector<QueryError> errors;
    for (std::size_t g = 0; g < request.grids.size(); ++g) {
        const QueryGrid& grid = request.grids[g];
        GridValues values = measure_grid(grid, rows_of(tested, grid, g, material),
                                         rows_of(reference, grid, g, material), errors);
        if (request.keep_values) result.values.push_back(std::move(values));
    }
    result.errors = summarize(errors);
    result.passed = within(result.errors, tolerance);
    const std::size_t worst = result.errors.worst;
    result.worst =
        worst_query(request, tested, reference, material, worst, errors[worst].component);
    return result;
}

// Runs a backend that can run here and fills in what it did.
void run_backend(const CompareRequest& request, const BackendEntry& entry,
                 const Evaluation& reference, BackendResult& result) {
    const std::unique_ptr<Backend> backend = entry.create(request.options);
    result.device = backend->device();
    const Evaluation tested = evaluate(*backend, request, entry.name);
    result.seconds = tested.seconds;
    result.queries_per_second = rate(query_total(request), tested.seconds);
    for (std::size_t m = 0; m < request.materials.size(); ++m) {
        MaterialResult material = measure(request, result.tolerance, tested, reference, m);
        material.queries_per_second = result.queries_per_second;
        if (!material.passed && result.reason.empty())
            result.reason = failure_line(result, material);
        result.materials.push_back(std::move(material));
    }
}

BackendResult compare_backend(const CompareRequest& request, const BackendEntry& entry,
                              const Evaluation& reference) {
    BackendResult result;
    result.name = entry.name;
    result.tolerance = tolerance_of(entry.name, request.model);
    const Availability availability = entry.probe(request.options);
    result.device = availability.detail;
    if (!availability.usable) {
        result.device.clear();
        result.reason = availability.detail;
        if (!availability.remedy.empty()) result.reason += "; " + availability.remedy;
        return result;
    }
    try {
        run_backend(request, entry, reference, result);
    } catch (const std::exception& error) {
        result.materials.clear();
        result.reason = error.what();
    }
    result.status = result.reason.empty() ? Status::passed : Status::failed;
    return result;
}

std::vector<std::vector<GridValues>> reference_values(const CompareRequest& request,
                                                      const Evaluation& reference) {
    std::vector<std::vector<GridValues>> values(request.materials.size());
    for (std::size_t m = 0; m < values.size(); ++m)
        for (std::size_t g = 0; g < request.grids.size(); ++g)
            values[m].push_back({to_float(rows_of(reference, request.grids[g], g, m)), {}});
    return values;
}

double largest(const BackendResult& backend, double ErrorSummary::*measure) {
    double most = 0.0;
    for (const MaterialResult& material : backend.materials)
        most = std::max(most, material.errors.*measure);
    return most;
}

}  // namespace

std::size_t step_count(const CompareRequest& request) {
    return (request.backends.size() + 1) * request.grids.size();
}

std::string_view status_name(Status status) {
    switch (status) {
        case Status::passed:
            return "passed";
        case Status::failed:
            return "failed";
        case Status::skipped:
            return "skipped";
    }
    return "";
}

double BackendResult::max_rel() const {
    return largest(*this, &ErrorSummary::max_rel);
}

double BackendResult::p999_rel() const {
    return largest(*this, &ErrorSummary::p999_rel);
}

double BackendResult::median_rel() const {
    return largest(*this, &ErrorSummary::median_rel);
}

CompareResult run_compare(const CompareRequest& request) {
    CompareResult result;
    result.suite = request.suite;
    result.model = request.model;
    result.materials = request.materials;
    result.grids = request.grids;
    const std::unique_ptr<Backend> backend = request.reference->create(request.options);
    result.reference_device = backend->device();
    const Evaluation reference = evaluate(*backend, request, request.reference->name);
    result.reference_queries_per_second = rate(query_total(request), reference.seconds);
    if (request.keep_values) result.reference_values = reference_values(request, reference);
    for (const BackendEntry* entry : request.backends)
        result.backends.push_back(compare_backend(request, *entry, reference));
    return result;
}

std::vector<std::string> failures(const CompareResult& result) {
    std::vector<std::string> lines;
    for (const BackendResult& backend : result.backends) {
        if (backend.status != Status::failed) continue;
        if (backend.materials.empty())
            lines.push_back(fmt::format("backend '{}': {}", backend.name, backend.reason));
        for (const MaterialResult& material : backend.materials)
            if (!material.passed) lines.push_back(failure_line(backend, material));
    }
    return lines;
}

std::string failure_line(const BackendResult& backend, const MaterialResult& material) {
    const ErrorSummary& errors = material.errors;
    const WorstQuery& worst = material.worst;
    std::string line = fmt::format("backend '{}' on material '{}': ", backend.name, material.name);
    if (errors.non_finite > 0)
        line += fmt::format("{} of {} results are not finite", errors.non_finite, errors.queries);
    else if (errors.max_rel > backend.tolerance.max_rel)
        line += fmt::format("maximum relative error {:.2e} exceeds {:.0e}", errors.max_rel,
                            backend.tolerance.max_rel);
    else
        line += fmt::format("median relative error {:.2e} exceeds {:.0e}", errors.median_rel,
                            backend.tolerance.median_rel);
    return line + fmt::format("; worst query wi {} wo {} ({}): {} is {:.9g}, reference {:.17g}",
                              exact_text(worst.query.wi), exact_text(worst.query.wo), worst.grid,
                              worst.component, worst.value, worst.reference);
}

std::string exact_text(const glm::vec3& w) {
    return fmt::format("{:.9g},{:.9g},{:.9g}", w.x, w.y, w.z);
}

std::string replay_command(const BackendResult& backend, const MaterialResult& material) {
    return fmt::format(
        "printf 'wi_x,wi_y,wi_z,wo_x,wo_y,wo_z\\n{},{}\\n' | "
        "lacquer eval --material {} --backend {} --queries -",
        exact_text(material.worst.query.wi), exact_text(material.worst.query.wo), material.name,
        backend.name);
}

}  // namespace lacquer
