// Everything that can execute the kernels: one interface, one file per executor.
#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "backends/kernel.h"
#include "core/model.h"
#include "lacquer/material.h"

namespace lacquer {

// Most queries one job may hold: 2^27, whose rows still fit in memory.
inline constexpr std::uint64_t kMaxQueries = std::uint64_t{1} << 27;

// Work for a backend. Query i shades materials[i / queries_per_material] and reads
// input_rows(kernel) rows of `inputs`. Materials and inputs stay the caller's.
struct Job {
    Model model = Model::plain;
    Kernel kernel = Kernel::eval;
    std::span<const Material> materials;
    std::uint64_t queries_per_material = 1;
    std::span<const glm::vec4> inputs;
    KernelParameters parameters;  // the counts are filled in by run()

    // Saturates at 2^64 - 1.
    std::uint64_t query_count() const;
};

struct JobResult {
    std::vector<glm::dvec4> rows;  // result_rows(kernel) per query
    double seconds = 0.0;          // executing and moving data; no compilation
    // The kernels alone, by the device's own clock, where it has one.
    std::optional<double> device_seconds;
};

// Throws Error saying what is wrong: no queries or more than kMaxQueries, or another number of
// input rows than the materials and the kernel need.
void check_job(const Job& job);

class Backend {
 public:
    virtual ~Backend() = default;

    // Compiles what `model` and `kernel` need and runs it once, so that timings leave out what
    // happens the first time. Throws Error with the compiler's own message where it fails.
    virtual void prepare(Model model, Kernel kernel) = 0;

    // Runs a whole job, preparing it where need be. Throws Error for what check_job() finds, and
    // with the executor's own message where it fails.
    virtual JobResult run(const Job& job) = 0;

    // The device or compiler that executes, for reports.
    virtual std::string device() const = 0;
};

// What the caller may choose; empty means the embedded default.
struct BackendOptions {
    std::string device;       // part of a Vulkan device's name, or its index; empty: lavapipe
    bool validation = false;  // Vulkan validation layers; any message is an Error
};

// Whether a backend can run here, and if not, why and what to do about it.
struct Availability {
    bool usable = false;
    std::string detail;  // usable: the device; otherwise the reason
    std::string remedy;  // otherwise: what to install or set
};

struct BackendEntry {
    std::string_view name;
    std::string_view description;
    Availability (*probe)(const BackendOptions&);
    std::unique_ptr<Backend> (*create)(const BackendOptions&);  // throws Error when not usable
};

// All backends in the order of reports, the reference first.
std::span<const BackendEntry> all_backends();

// Throws UsageError listing the names there are.
const BackendEntry& backend_from_name(std::string_view name);

}  // namespace lacquer
