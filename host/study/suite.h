// The studies of papers: each suite makes the figures of one paper, with the simulator's answer and
// every model's error beside it.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "study/figure.h"
#include "study/run.h"

namespace lacquer::study {

struct FigureEntry {
    std::string_view id;
    Figure (*make)(const StudyRun& run);
};

inline constexpr std::string_view kSimulated =
    "The simulation sends light on random walks through the facets, media and base, every order of "
    "scattering, and knows no model. The models are those of the reference in double precision. "
    "Where an error is next to its noise, the simulation cannot tell it from 0.";

struct Suite {
    std::string_view name;   // on the command line
    std::string_view title;  // of its page
    std::string_view paper;  // authors, year, title
    std::string_view summary;
    std::span<const FigureEntry> figures;
    std::string_view method = kSimulated;  // how the page says that its numbers were found
};

struct StudyResult {
    const Suite* suite = nullptr;
    std::uint64_t samples = 0, seed = 0;
    double seconds = 0.0;
    std::vector<Figure> figures;
};

std::span<const Suite> all_suites();

// nullptr where there is none of that name.
const Suite* find_suite(std::string_view name);

// Makes all figures of a suite; `on_figure` is called after each of them.
StudyResult run_study(const Suite& suite, const StudyRun& run,
                      const std::function<void()>& on_figure);

}  // namespace lacquer::study
