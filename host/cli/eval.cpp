// `lacquer eval`: the BSDF and its sampling density for given directions.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/commands.h"
#include "cli/options.h"
#include "cli/query_file.h"
#include "core/error.h"

namespace lacquer {

namespace {

constexpr const char* kSummary = "Evaluate a material for pairs of directions";

constexpr const char* kHelp =
    R"(Reads comma-separated rows wi_x,wi_y,wi_z,wo_x,wo_y,wo_z under that header and prints them
with f_r,f_g,f_b,pdf appended: the BSDF per steradian without the cosine, and the density per
steradian of sampling wi for wo. Directions are unit vectors in the surface's frame, z its
normal, wi towards the light and wo towards the viewer. Every backend gets them rounded to
floats.

Examples:
  lacquer eval --material gold --queries queries.csv
  lacquer eval --material mine.json --queries - --backend vulkan < queries.csv > results.csv)";

struct Arguments {
    ShadingOptions shading;
    std::filesystem::path queries;
};

glm::vec4 input_row(const glm::dvec3& w) {
    return {static_cast<float>(w.x), static_cast<float>(w.y), static_cast<float>(w.z), 0.0f};
}

// Enough digits to read back what was computed: the reference computes in double, the others in
// float.
int digits_of(const std::string& backend) {
    return backend == "reference" ? 17 : 9;
}

std::string results_text(const std::vector<QueryRow>& queries, const JobResult& result,
                         int digits) {
    std::string text = fmt::format("{},f_r,f_g,f_b,pdf\n", kQueryHeader);
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const glm::dvec4& row = result.rows[i];
        text += fmt::format("{0},{2:.{1}g},{3:.{1}g},{4:.{1}g},{5:.{1}g}\n", queries[i].text,
                            digits, row.x, row.y, row.z, row.w);
    }
    return text;
}

void run(const Arguments& arguments) {
    const std::vector<QueryRow> queries = read_queries(arguments.queries);
    const Shading shading = open_shading(arguments.shading);
    require_untextured(shading.material);
    std::vector<glm::vec4> inputs;
    inputs.reserve(2 * queries.size());
    for (const QueryRow& query : queries) {
        inputs.push_back(input_row(query.wi));
        inputs.push_back(input_row(query.wo));
    }
    Job job;
    job.model = shading.model;
    job.kernel = Kernel::eval;
    job.materials = {&shading.material, 1};
    job.queries_per_material = queries.size();
    job.inputs = inputs;
    print_data(
        results_text(queries, shading.backend->run(job), digits_of(arguments.shading.backend)));
}

}  // namespace

void add_eval_command(CLI::App& app) {
    auto arguments = std::make_shared<Arguments>();
    CLI::App* command = app.add_subcommand("eval", kSummary)->footer(kHelp);
    add_shading_options(*command, arguments->shading);
    command
        ->add_option("--queries", arguments->queries,
                     "File of directions; - reads the standard input")
        ->required();
    command->callback([arguments] { run(*arguments); });
}

}  // namespace lacquer
