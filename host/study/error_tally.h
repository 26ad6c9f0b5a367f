// Differences between a model and its simulation, added up.
#pragma once

#include <string>

#include "study/figure.h"

namespace lacquer::study {

class ErrorTally {
 public:
    // The largest difference is that beyond so many `sure_errors` standard errors: of many noisy
    // ones, the largest would else be that of noise.
    ErrorTally(std::string subject, std::string model, double sure_errors = 0.0);

    // |difference| counts `weight` times in the mean; `standard_error` is the simulation's, and
    // `where` is asked for only where this is the largest so far.
    template <typename Where>
    void add(double difference, double standard_error, const Where& where, double weight = 1.0) {
        if (count(difference, standard_error, weight)) error_.where = where();
    }

    // The means over all weights, or over `total` where that is what they are shares of.
    ModelError result() const;
    ModelError result(double total) const;

 private:
    bool count(double difference, double standard_error, double weight);  // whether it is largest

    ModelError error_;
    double sure_errors_;
    double sum_ = 0.0, noise_ = 0.0, weights_ = 0.0;
};

}  // namespace lacquer::study
