#include "study/suite.h"

#include <algorithm>
#include <array>
#include <chrono>

#include "study/diffuse_interfaces/suite.h"
#include "study/heightfields/suite.h"
#include "study/layered/suite.h"

namespace lacquer::study {

namespace {

const std::array kSuites{kDiffuseInterfaces, kLayered, kHeightfields};

}  // namespace

std::span<const Suite> all_suites() {
    return kSuites;
}

const Suite* find_suite(std::string_view name) {
    const auto found = std::ranges::find(kSuites, name, &Suite::name);
    return found == kSuites.end() ? nullptr : &*found;
}

StudyResult run_study(const Suite& suite, const StudyRun& run,
                      const std::function<void()>& on_figure) {
    const auto start = std::chrono::steady_clock::now();
    StudyResult result{&suite, run.samples, run.seed, 0.0, {}};
    for (const FigureEntry& entry : suite.figures) {
        result.figures.push_back(entry.make(run));
        if (on_figure) on_figure();
    }
    result.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

}  // namespace lacquer::study
