#include "cli/walk_rate.h"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <ctime>
#include <nlohmann/json.hpp>

#include "cli/median.h"
#include "core/table.h"
#include "simulator/estimator.h"
#include "simulator/microsurface.h"

namespace lacquer {

namespace {

constexpr std::uint64_t kWalks = 1 << 20;  // per run, a tenth of a second or more
constexpr double kEta = 1.5;               // ior below / ior above
constexpr double kCosine = 0.5;            // of the direction of arrival
constexpr double kAlphas[] = {0.1, 0.5, 1.0};

double core_seconds() {
    timespec now{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct EnteredTally {
    std::uint64_t entered = 0;
    std::uint64_t count = 0;

    void merge(const EnteredTally& other) { entered += other.entered; }
};

double seconds_of_walks(const simulator::SurfaceWalk& surface, std::uint64_t seed) {
    const simulator::Vec3 downwards{std::sqrt(1.0 - kCosine * kCosine), 0.0, -kCosine};
    const double start = core_seconds();
    simulator::run_walks<EnteredTally>(
        {kWalks, seed, {}}, [&](simulator::RandomStream& random, EnteredTally& tally) {
            tally.entered += surface.cross(downwards, random).below ? 1 : 0;
        });
    return core_seconds() - start;
}

double walk_rate(Ndf ndf, double alpha, int runs) {
    const simulator::SurfaceWalk surface{
        {Blend::Operator::asymmetric,
         {{1.0, {ndf, alpha, alpha}, simulator::DielectricFacet{kEta}}}}};
    std::vector<double> seconds;
    for (int run = 0; run < runs; ++run)
        seconds.push_back(seconds_of_walks(surface, static_cast<std::uint64_t>(run)));
    return static_cast<double>(kWalks) / median(seconds);
}

std::string name_of(Ndf ndf) {
    return ndf == Ndf::ggx ? "ggx" : "beckmann";
}

}  // namespace

std::vector<WalkRate> measure_walk_rates(int runs) {
    std::vector<WalkRate> rates;
    tbb::task_arena one_core{1};
    one_core.execute([&] {
        for (const Ndf ndf : {Ndf::ggx, Ndf::beckmann})
            for (const double alpha : kAlphas)
                rates.push_back({ndf, alpha, walk_rate(ndf, alpha, runs)});
    });
    return rates;
}

std::string table_text(const std::vector<WalkRate>& rates) {
    std::vector<std::vector<std::string>> rows;
    for (const WalkRate& rate : rates)
        rows.push_back({fmt::format("{}, eta {}, alpha {}", name_of(rate.ndf), kEta, rate.alpha),
                        fmt::format("{:.1f}", rate.walks_per_core_second * 1e-6)});
    return format_table({{"simulator"}, {"Mwalks/s and core", Align::right}}, rows);
}

nlohmann::ordered_json to_json(const std::vector<WalkRate>& rates) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const WalkRate& rate : rates)
        list.push_back({{"ndf", name_of(rate.ndf)},
                        {"eta", kEta},
                        {"alpha", rate.alpha},
                        {"cos", kCosine},
                        {"walks_per_core_second", rate.walks_per_core_second}});
    return list;
}

}  // namespace lacquer
