#include "cli/simulate_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <limits>

#include "core/error.h"

namespace lacquer {

namespace {

volatile std::sig_atomic_t stop_requested = 0;

void request_stop(int) {
    stop_requested = 1;
    std::signal(SIGINT, SIG_DFL);
}

std::string names_of(std::span<const Method> methods) {
    std::string names;
    for (const Method& method : methods) names += (names.empty() ? "" : ", ") + method.name;
    return names;
}

}  // namespace

void add_walk_options(CLI::App& command, SimulateOptions& options,
                      const std::string& samples_help) {
    command.add_option("--samples", options.samples, samples_help);
    command.add_option("--seed", options.seed, "Of the random numbers of a simulation")
        ->check(CLI::Range(std::int64_t{0}, std::numeric_limits<std::int64_t>::max()))
        ->capture_default_str();
}

void add_orders_option(CLI::App& command, SimulateOptions& options) {
    command
        .add_option("--orders", options.orders,
                    "Facets that simulated light may meet at one visit of an interface: all, or 1 "
                    "for single scattering, which loses the rest")
        ->check(CLI::IsMember({"1", "all"}))
        ->capture_default_str();
}

std::uint64_t walk_count(const SimulateOptions& options, std::int64_t default_walks) {
    const std::int64_t walks = options.samples.value_or(default_walks);
    if (walks >= 1 && walks <= kMaxWalks) return static_cast<std::uint64_t>(walks);
    throw UsageError{fmt::format("--samples: {} is not in [1, {}]", walks, kMaxWalks)};
}

simulator::StackOptions stack_options(const SimulateOptions& options) {
    return {options.orders == "1" ? 1 : simulator::kAllOrders};
}

Method model_method() {
    return {"model", {"--model", "--backend", "--device", "--validation"}};
}

void require_method(const CLI::App& command, const std::string& chosen,
                    std::span<const Method> methods) {
    const auto is_chosen = [&](const Method& method) { return method.name == chosen; };
    if (std::ranges::none_of(methods, is_chosen))
        throw UsageError{
            fmt::format("--method: '{}' is not one of: {}", chosen, names_of(methods))};
    for (const Method& method : methods)
        for (const std::string& option : method.own_options)
            if (!is_chosen(method) && command.count(option) > 0)
                throw UsageError{fmt::format("{} goes with --method {}, not with {}", option,
                                             method.name, chosen)};
}

SimulationRun::SimulationRun(std::uint64_t total_walks) : total_walks_{total_walks} {
    progress_.emplace("simulate", total_walks);
    stop_requested = 0;
    previous_handler_ = std::signal(SIGINT, request_stop);
}

SimulationRun::~SimulationRun() {
    std::signal(SIGINT, previous_handler_);
    progress_.reset();  // clears its line
    if (!stopped() || done_ == total_walks_) return;
    std::fputs(fmt::format("lacquer: stopped after {} of {} walks; the result is of those\n", done_,
                           total_walks_)
                   .c_str(),
               stderr);
}

simulator::RunOptions SimulationRun::next(std::uint64_t samples, std::int64_t seed) {
    done_before_ = done_;
    return {samples, static_cast<std::uint64_t>(seed),
            [this](std::uint64_t done) { return keep_going(done); }};
}

bool SimulationRun::stopped() const {
    return stop_requested != 0;
}

bool SimulationRun::keep_going(std::uint64_t done_of_this) {
    progress_->advance(done_before_ + done_of_this - done_);
    done_ = done_before_ + done_of_this;
    return !stopped();
}

}  // namespace lacquer
