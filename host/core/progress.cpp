#include "core/progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace lacquer {

namespace {

constexpr std::size_t kBarWidth = 24;
constexpr std::size_t kDefaultWidth = 100;
constexpr std::chrono::milliseconds kQuietTime{400};  // work that ends sooner shows nothing
constexpr std::chrono::milliseconds kRedrawTime{100};
constexpr std::chrono::seconds kLineTime{10};  // where stderr is not a terminal

std::size_t terminal_width() {
    winsize size{};
    if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return kDefaultWidth;
    return size.ws_col;
}

}  // namespace

std::string duration_text(double seconds) {
    const auto whole = static_cast<long long>(std::llround(std::max(seconds, 0.0)));
    if (whole < 60) return fmt::format("{} s", whole);
    if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
    return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

std::string progress_line(std::string_view label, std::uint64_t done, std::uint64_t total,
                          double elapsed_s, std::string_view note, std::size_t width) {
    const double share =
        total == 0 ? 1.0 : std::min(static_cast<double>(done) / static_cast<double>(total), 1.0);
    const auto filled = static_cast<std::size_t>(share * static_cast<double>(kBarWidth));
    std::string line = fmt::format("{} [{}{}] {:3.0f} %", label, std::string(filled, '#'),
                                   std::string(kBarWidth - filled, '.'), std::floor(100 * share));
    if (done > 0 && done < total)
        line += fmt::format(", {} left", duration_text(elapsed_s * (1.0 / share - 1.0)));
    if (!note.empty()) line += fmt::format("  {}", note);
    if (line.size() > width) line.resize(width);
    return line;
}

Progress::Progress(std::string label, std::uint64_t total)
    : label_{std::move(label)},
      total_{total},
      terminal_{::isatty(STDERR_FILENO) == 1},
      start_{Clock::now()},
      next_draw_{start_ + (terminal_ ? Clock::duration{kQuietTime} : Clock::duration{kLineTime})} {}

Progress::~Progress() {
    if (drawn_ && terminal_) std::fputs("\r\x1b[K", stderr);
}

void Progress::advance(std::uint64_t steps) {
    const std::lock_guard lock{mutex_};
    done_ += steps;
    draw();
}

void Progress::note(std::string_view text) {
    const std::lock_guard lock{mutex_};
    note_ = text;
    draw();
}

void Progress::draw() {
    const Clock::time_point now = Clock::now();
    if (now < next_draw_) return;
    next_draw_ = now + (terminal_ ? Clock::duration{kRedrawTime} : Clock::duration{kLineTime});
    drawn_ = true;
    const double elapsed_s = std::chrono::duration<double>(now - start_).count();
    const std::size_t width = terminal_ ? terminal_width() - 1 : kDefaultWidth;
    const std::string line = progress_line(label_, done_, total_, elapsed_s, note_, width);
    const std::string text = terminal_ ? "\r" + line + "\x1b[K" : line + "\n";
    std::fputs(text.c_str(), stderr);  // where stderr is closed, the work goes on all the same
    std::fflush(stderr);
}

}  // namespace lacquer
