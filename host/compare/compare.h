// The regression run: every backend against the reference, on every material.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "backends/backend.h"
#include "compare/grids.h"
#include "compare/metrics.h"
#include "compare/tolerances.h"
#include "core/model.h"
#include "lacquer/material.h"

namespace lacquer {

// A material under the name that the command line's --material takes.
struct NamedMaterial {
    std::string name;
    Material material;
};

struct CompareRequest {
    std::string suite;  // the name of `grids`
    Model model = Model::plain;
    std::vector<NamedMaterial> materials;           // at least one
    std::vector<QueryGrid> grids;                   // at least one
    std::vector<const BackendEntry*> backends;      // what is compared
    const BackendEntry* reference = nullptr;        // with what
    BackendOptions options;                         // for all of them
    bool keep_values = false;                       // for pictures; some megabytes per result
    std::function<void(std::string_view)> on_step;  // before each of step_count(...) steps
};

// How many times on_step is called when every backend can run.
std::size_t step_count(const CompareRequest& request);

// The query with the largest relative error.
struct WorstQuery {
    std::string grid;
    Query query;
    std::string component;  // f_r, f_g, f_b, pdf, or radiance_r, radiance_g, radiance_b
    double value = 0.0, reference = 0.0;
};

// Results and errors over one grid, one per query.
struct GridValues {
    std::vector<glm::vec4> rows;
    std::vector<float> relative_errors;
};

struct MaterialResult {
    std::string name;
    ErrorSummary errors;
    WorstQuery worst;
    double queries_per_second = 0.0;
    bool passed = false;
    std::vector<GridValues> values;  // per grid, where asked for
};

enum class Status { passed, failed, skipped };

std::string_view status_name(Status status);

struct BackendResult {
    std::string name;
    Status status = Status::skipped;
    std::string device;  // where it ran
    std::string reason;  // why it failed or was skipped; empty where it passed
    Tolerance tolerance{};
    double seconds = 0.0;                   // executing and moving data, all materials
    double queries_per_second = 0.0;        // over all grids and materials
    std::vector<MaterialResult> materials;  // none where it was skipped or broke down

    // Over all materials: the largest of each measure.
    double max_rel() const;
    double p999_rel() const;
    double median_rel() const;
};

struct CompareResult {
    std::string suite;
    Model model = Model::plain;
    std::vector<NamedMaterial> materials;
    std::vector<QueryGrid> grids;
    std::string reference_device;
    double reference_queries_per_second = 0.0;
    std::vector<std::vector<GridValues>> reference_values;  // [material][grid], where asked for
    std::vector<BackendResult> backends;
};

// Runs the comparison. A backend that cannot run here is skipped; one that breaks down while it
// runs has failed, and the others go on. Throws Error where the reference itself cannot run.
CompareResult run_compare(const CompareRequest& request);

// What is wrong with `result`, one line per backend and material past its tolerance or broken
// backend, with the query as `lacquer eval` takes it; empty where nothing failed.
std::vector<std::string> failures(const CompareResult& result);

// What is wrong with one result past its tolerance, in one line.
std::string failure_line(const BackendResult& backend, const MaterialResult& material);

// A command that evaluates the worst query again.
std::string replay_command(const BackendResult& backend, const MaterialResult& material);

// Numbers of a direction so that reading them gives the same floats.
std::string exact_text(const glm::vec3& w);

}  // namespace lacquer
