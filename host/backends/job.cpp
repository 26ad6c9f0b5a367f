#include <fmt/format.h>

#include <limits>

#include "backends/backend.h"
#include "core/error.h"

namespace lacquer {

std::uint64_t Job::query_count() const {
    std::uint64_t count = 0;
    if (__builtin_mul_overflow(std::uint64_t{materials.size()}, queries_per_material, &count))
        return std::numeric_limits<std::uint64_t>::max();
    return count;
}

void check_job(const Job& job) {
    const KernelShape shape = kernel_shape(job.kernel);
    const std::uint64_t count = job.query_count();
    if (count == 0 || count > kMaxQueries)
        throw Error{fmt::format("kernel '{}': {} queries; a job holds 1 to {}", shape.name, count,
                                kMaxQueries)};
    if (job.inputs.size() != count * shape.input_rows)
        throw Error{fmt::format("kernel '{}': {} input rows for {} queries; each takes {}",
                                shape.name, job.inputs.size(), count, shape.input_rows)};
}

}  // namespace lacquer
