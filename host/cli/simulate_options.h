// What the commands that simulate share: their options, and a run that shows its progress and can
// be stopped with Ctrl-C.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/progress.h"
#include "simulator/estimator.h"
#include "simulator/stack.h"

namespace CLI {
class App;
}

namespace lacquer {

// Counts are signed, so that one below zero is refused and not taken for a large one.
struct SimulateOptions {
    std::optional<std::int64_t> samples;
    std::int64_t seed = 1;
    std::string orders = "all";
};

// Adds --samples, which `samples_help` describes, and --seed.
void add_walk_options(CLI::App& command, SimulateOptions& options, const std::string& samples_help);

// Adds --orders.
void add_orders_option(CLI::App& command, SimulateOptions& options);

// Number of walks asked for. Throws UsageError outside [1, kMaxWalks].
std::uint64_t walk_count(const SimulateOptions& options, std::int64_t default_walks);

inline constexpr std::int64_t kMaxWalks = std::int64_t{1} << 40;

simulator::StackOptions stack_options(const SimulateOptions& options);

// A value of --method with the options that go with no other.
struct Method {
    std::string name;
    std::vector<std::string> own_options;
};

inline constexpr const char* kSimulateMethod = "simulate";

// Shading by a model, the method of add_shading_options().
Method model_method();

// Throws UsageError where `chosen` is none of `methods`, or where an option was given that goes
// with another one.
void require_method(const CLI::App& command, const std::string& chosen,
                    std::span<const Method> methods);

// One or several simulations that share a progress bar. While it lives, the first Ctrl-C stops the
// simulations after what they have begun, which is noted on stderr at the end with the number of
// walks made; the second ends the program.
class SimulationRun {
 public:
    explicit SimulationRun(std::uint64_t total_walks);
    ~SimulationRun();
    SimulationRun(const SimulationRun&) = delete;
    SimulationRun& operator=(const SimulationRun&) = delete;

    // For the next simulation; valid as long as this run.
    simulator::RunOptions next(std::uint64_t samples, std::int64_t seed);

    bool stopped() const;

 private:
    bool keep_going(std::uint64_t done_of_this);

    std::uint64_t total_walks_;
    std::uint64_t done_before_ = 0;  // by earlier simulations
    std::uint64_t done_ = 0;
    std::optional<Progress> progress_;
    void (*previous_handler_)(int);
};

}  // namespace lacquer
