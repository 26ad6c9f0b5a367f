#include "stack_errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lacquer::test {

void Errors::add(double error, double noise, const std::string& where) {
    sizes_.push_back(std::abs(error));
    sum_ += error;
    noise_ = std::max(noise_, noise);
    if (sizes_.back() < worst_) return;
    worst_ = sizes_.back();
    where_ = where;
}

double Errors::mean() const {
    return std::accumulate(sizes_.begin(), sizes_.end(), 0.0) / static_cast<double>(sizes_.size());
}

double Errors::share_within(double size) const {
    const auto within = std::ranges::count_if(sizes_, [&](double s) { return s <= size; });
    return static_cast<double>(within) / static_cast<double>(sizes_.size());
}

void Errors::print(const std::string& name) const {
    std::vector<double> sorted = sizes_;
    std::ranges::sort(sorted);
    fmt::print("{:<32} mean {:.4f} (bias {:+.4f}) p95 {:.4f} max {:.4f} of {} at {}\n", name,
               mean(), sum_ / static_cast<double>(sorted.size()), sorted[sorted.size() * 95 / 100],
               worst_, sorted.size(), where_);
}

}  // namespace lacquer::test
