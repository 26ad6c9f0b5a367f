// Errors of a model against simulations, of which the largest is remembered.
#pragma once

#include <string>
#include <vector>

namespace lacquer::test {

class Errors {
 public:
    // Of a value whose truth has the standard error `noise`.
    void add(double error, double noise, const std::string& where);

    double mean() const;  // of their sizes
    double worst() const { return worst_; }
    double noise() const { return noise_; }  // the largest
    std::size_t count() const { return sizes_.size(); }

    // The share of errors of at most this size.
    double share_within(double size) const;

    // To stdout, in one line.
    void print(const std::string& name) const;

 private:
    std::vector<double> sizes_;
    double sum_ = 0.0, worst_ = -1.0, noise_ = 0.0;
    std::string where_;
};

}  // namespace lacquer::test
