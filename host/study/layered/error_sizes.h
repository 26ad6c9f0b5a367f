// Errors of a model whose distribution is told: mean, 95th percentile and largest.
#pragma once

#include <string>
#include <vector>

#include "study/error_tally.h"

namespace lacquer::study {

class ErrorSizes {
 public:
    ErrorSizes(std::string subject, std::string model);

    // See ErrorTally::add.
    template <typename Where>
    void add(double difference, double standard_error, const Where& where) {
        tally_.add(difference, standard_error, where);
        sizes_.push_back(difference);
    }

    ModelError result() const { return tally_.result(); }

    // The least |difference| that so large a share of all does not exceed; 0 where there is none.
    double quantile(double share) const;

    // A row of a table with error_columns.
    std::vector<std::string> row() const;

 private:
    ErrorTally tally_;
    std::vector<double> sizes_;
};

// Titles of the columns; `what` and `model` are those of the first two.
std::vector<std::string> error_columns(const std::string& what, const std::string& model);

}  // namespace lacquer::study
