// How far a long piece of work has come, on stderr.
#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>

namespace lacquer {

// One line of progress: label, bar, share done, remaining time guessed from the pace so far (none
// before the first step), and what is being done. `width` is the line's length in columns.
std::string progress_line(std::string_view label, std::uint64_t done, std::uint64_t total,
                          double elapsed_s, std::string_view note, std::size_t width);

// Seconds as a person says them: "8 s", "2 min 05 s", "1 h 02 min".
std::string duration_text(double seconds);

// Work of `total` steps. On a terminal, a bar that is redrawn in place and cleared at the end;
// where stderr is a file, a line every ten seconds. Work that ends at once shows nothing. Safe to
// advance from several threads.
class Progress {
 public:
    Progress(std::string label, std::uint64_t total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    // Counts finished steps.
    void advance(std::uint64_t steps = 1);

    // Says what is being done now.
    void note(std::string_view text);

 private:
    using Clock = std::chrono::steady_clock;

    void draw();  // where it is time to

    std::mutex mutex_;
    std::string label_;
    std::string note_;
    std::uint64_t total_;
    std::uint64_t done_ = 0;
    bool terminal_;
    bool drawn_ = false;
    Clock::time_point start_;
    Clock::time_point next_draw_;
};

}  // namespace lacquer
