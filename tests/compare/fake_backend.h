// Backends of the tests' own: a small formula, right or broken in a chosen way.
#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "backends/backend.h"
#include "compare/compare.h"
#include "core/error.h"

namespace lacquer::test {

// f of query `query` on the material of index `material`, which a test may change.
using Breakage = std::function<void(std::size_t material, std::size_t query, glm::dvec4& row)>;

// Computes (cos_i + cos_o, ...) / pi times the material's exterior index: enough to tell materials
// and directions apart.
class FakeBackend : public Backend {
 public:
    explicit FakeBackend(Breakage breakage = {}) : breakage_{std::move(breakage)} {}

    void prepare(Model, Kernel) override {}

    JobResult run(const Job& job) override {
        JobResult result;
        result.seconds = 0.5;
        const std::size_t count = job.materials.size() * job.queries_per_material;
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t material = i / job.queries_per_material;
            const double f =
                job.materials[material].exterior_ior * cosines(job, i) / std::numbers::pi;
            glm::dvec4 row{f, 2.0 * f, 3.0 * f, job.kernel == Kernel::sphere ? 1.0 : 0.5};
            if (breakage_) breakage_(material, i % job.queries_per_material, row);
            result.rows.push_back(row);
        }
        return result;
    }

    std::string device() const override { return "a formula"; }

 private:
    static double cosines(const Job& job, std::size_t query) {
        if (job.kernel == Kernel::slice) return 2.0 + job.inputs[query].z + job.parameters.wo[2];
        return 2.0 + job.inputs[2 * query].z + job.inputs[2 * query + 1].z;
    }

    Breakage breakage_;
};

inline Availability usable(const BackendOptions&) {
    return {true, "a formula", ""};
}

inline Availability missing(const BackendOptions&) {
    return {false, "no driver <here>", "install one"};
}

inline std::unique_ptr<Backend> make_right(const BackendOptions&) {
    return std::make_unique<FakeBackend>();
}

// Query 7 of the second material is off by one part in a thousand, on every grid.
inline std::unique_ptr<Backend> make_wrong(const BackendOptions&) {
    return std::make_unique<FakeBackend>(
        [](std::size_t material, std::size_t query, glm::dvec4& row) {
            if (material == 1 && query == 7) row.y *= 1.001;
        });
}

inline std::unique_ptr<Backend> make_not_a_number(const BackendOptions&) {
    return std::make_unique<FakeBackend>(
        [](std::size_t material, std::size_t query, glm::dvec4& row) {
            if (material == 0 && query == 3) row.x = std::numeric_limits<double>::quiet_NaN();
        });
}

// Off everywhere by less than the maximum allows, but by more than the median does.
inline std::unique_ptr<Backend> make_imprecise(const BackendOptions&) {
    return std::make_unique<FakeBackend>(
        [](std::size_t, std::size_t, glm::dvec4& row) { row *= 1.0 + 1e-6; });
}

inline std::unique_ptr<Backend> make_crashing(const BackendOptions&) {
    throw Error{"the device was lost"};
}

inline constexpr BackendEntry kReference{"reference", "", usable, make_right};
inline constexpr BackendEntry kRight{"right", "", usable, make_right};
inline constexpr BackendEntry kWrong{"wrong", "", usable, make_wrong};
inline constexpr BackendEntry kNotANumber{"nan", "", usable, make_not_a_number};
inline constexpr BackendEntry kImprecise{"imprecise", "", usable, make_imprecise};
inline constexpr BackendEntry kMissing{"missing", "", missing, make_right};
inline constexpr BackendEntry kCrashing{"crashing", "", usable, make_crashing};

// Two materials on a small slice and a small sphere.
inline CompareRequest small_request(std::vector<const BackendEntry*> backends) {
    CompareRequest request;
    request.suite = "small";
    for (const auto& [name, ior] : {std::pair{"first", 1.0}, std::pair{"second", 1.5}}) {
        Material material;
        material.name = std::string{"the "} + name + " & only";
        material.exterior_ior = ior;
        request.materials.push_back({name, material});
    }
    request.grids = {slice_grid("slice 30", direction_at(30.0), 16),
                     sphere_grid("sphere", default_light(), 16)};
    request.backends = std::move(backends);
    request.reference = &kReference;
    return request;
}

}  // namespace lacquer::test
