// How jobs are checked and split, on a backend that only records; and that every backend puts the
// parts together again.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>

#include "backends/float_backend.h"
#include "backends/jobs.h"
#include "backends/pack.h"
#include "core/error.h"

namespace lacquer::test {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

// Returns in each row the global query it should belong to, as its own inputs tell.
class RecordingBackend final : public FloatBackend {
 public:
    std::vector<KernelParameters> dispatches;
    std::vector<std::size_t> surface_counts;
    int compilations = 0;

    std::string device() const override { return "none"; }

 private:
    void compile(Model, Kernel) override { ++compilations; }

    std::optional<double> execute(const Dispatch& dispatch, std::span<glm::vec4> results) override {
        dispatches.push_back(dispatch.parameters);
        surface_counts.push_back(dispatch.surfaces.size() / surface_rows(dispatch.model));
        for (std::size_t query = 0; query < results.size(); ++query) {
            const std::size_t surface = query / dispatch.parameters.queries_per_surface;
            results[query] = {dispatch.inputs[2 * query].x,
                              dispatch.surfaces[surface * surface_rows(dispatch.model) + 2].x, 0,
                              0};
        }
        return 0.25;
    }
};

// Materials whose albedo tells which they are: i / `scale`.
std::vector<Material> numbered_materials(std::size_t count, double scale = 1.0) {
    std::vector<Material> materials(count);
    for (std::size_t i = 0; i < count; ++i)
        materials[i].base = LambertianBase{{static_cast<double>(i) / scale, 0, 0}};
    return materials;
}

OwnedJob numbered_job(std::size_t material_count, std::uint64_t queries_per_material) {
    OwnedJob owned{Kernel::eval, numbered_materials(material_count), queries_per_material, {}, {}};
    for (std::size_t query = 0; query < material_count * queries_per_material; ++query) {
        owned.inputs.emplace_back(static_cast<float>(query), 0, 0, 0);
        owned.inputs.emplace_back(0.0f);
    }
    return owned;
}

struct Split {
    std::size_t materials;
    std::uint64_t queries_per_material;
    std::size_t dispatches;
};

constexpr std::uint64_t kMost = kMaxDispatchQueries;

class JobSplit : public ::testing::TestWithParam<Split> {};

TEST_P(JobSplit, CoversEveryQueryWithItsOwnMaterial) {
    const auto [material_count, queries_per_material, dispatch_count] = GetParam();
    const OwnedJob owned = numbered_job(material_count, queries_per_material);
    RecordingBackend backend;
    const JobResult result = backend.run(owned.job());

    // The first dispatch is the one query of prepare().
    ASSERT_EQ(backend.dispatches.size(), 1 + dispatch_count);
    EXPECT_DOUBLE_EQ(result.device_seconds.value(), 0.25 * static_cast<double>(dispatch_count));
    for (std::size_t i = 1; i < backend.dispatches.size(); ++i) {
        const KernelParameters& part = backend.dispatches[i];
        EXPECT_LE(part.query_count, kMost);
        EXPECT_LE(part.query_count,
                  std::uint64_t{backend.surface_counts[i]} * queries_per_material);
    }
    ASSERT_EQ(result.rows.size(), material_count * queries_per_material);
    for (std::size_t query = 0; query < result.rows.size(); ++query) {
        ASSERT_EQ(result.rows[query].x, static_cast<double>(query));
        ASSERT_EQ(result.rows[query].y, static_cast<double>(query / queries_per_material));
    }
}

INSTANTIATE_TEST_SUITE_P(
    Boundaries, JobSplit,
    ::testing::Values(Split{1, 1, 1}, Split{1, kMost - 1, 1}, Split{1, kMost, 1},
                      Split{1, kMost + 1, 2}, Split{3, kMost + 1, 6}, Split{2, kMost / 2, 1},
                      Split{3, kMost / 2, 2}, Split{3, kMost / 2 + 1, 3}, Split{150'000, 7, 2},
                      Split{1000, 1, 1}, Split{1000, 1021, 1}, Split{1100, 1021, 2}),
    [](const ::testing::TestParamInfo<Split>& test) {
        return fmt::format("{}x{}", test.param.materials, test.param.queries_per_material);
    });

TEST(Job, CompilesAKernelOnce) {
    RecordingBackend backend;
    const OwnedJob owned = numbered_job(1, 1);
    backend.run(owned.job());
    backend.run(owned.job());
    EXPECT_EQ(backend.compilations, 1);
}

// What check_job refuses, and what it says.
TEST(Job, RefusesQueryCountsOutOfRange) {
    const std::vector<Material> materials(1);
    Job job{Model::plain, Kernel::eval, materials, 0, {}, {}};
    EXPECT_THAT([&] { check_job(job); },
                ThrowsMessage<Error>(HasSubstr("0 queries; a job holds 1 to 134217728")));
    job.queries_per_material = std::uint64_t{1} << 31;
    EXPECT_THAT([&] { check_job(job); }, ThrowsMessage<Error>(HasSubstr("2147483648 queries")));
    const std::vector<Material> two(2);
    job.materials = two;
    job.queries_per_material = std::uint64_t{1} << 63;  // the product overflows
    EXPECT_THAT([&] { check_job(job); }, ThrowsMessage<Error>(HasSubstr("queries; a job holds")));
    job.materials = {};
    job.queries_per_material = 1;
    EXPECT_THAT([&] { check_job(job); }, ThrowsMessage<Error>(HasSubstr("0 queries")));
}

TEST(Job, RefusesInputsThatDoNotFit) {
    OwnedJob owned = numbered_job(2, 3);
    owned.inputs.pop_back();
    EXPECT_THAT([&] { check_job(owned.job()); },
                ThrowsMessage<Error>(HasSubstr("11 input rows for 6 queries; each takes 2")));
}

TEST(Pack, NamesWhatTheModelCannotShade) {
    const Blend blend{Blend::Operator::symmetric, {Stratum{}, Stratum{}}};
    const std::vector<Material> materials{{"patina", 1.0, {}, ConductorBase{{}, {}, blend}, {}}};
    EXPECT_THAT([&] { pack_surfaces(Model::plain, materials); },
                ThrowsMessage<Error>(
                    ::testing::AllOf(HasSubstr("patina"), HasSubstr("/base/conductor/blend"))));
}

class EveryBackend : public ::testing::TestWithParam<std::string> {
 protected:
    void SetUp() override {
        std::string skipped;
        backend_ = create_or_explain(GetParam(), skipped);
        if (!backend_) GTEST_SKIP() << skipped;
    }

    std::unique_ptr<Backend> backend_;
};

std::string backend_test_name(const ::testing::TestParamInfo<std::string>& test) {
    std::string name = test.param;
    std::ranges::replace(name, '-', '_');
    return name;
}

// Small integers add without rounding.
void expect_sums(Backend& backend, std::uint64_t query_count) {
    OwnedJob owned{Kernel::copy, std::vector<Material>(1), query_count, {}, {}};
    for (std::uint64_t query = 0; query < query_count; ++query) {
        const auto number = static_cast<float>(query);
        owned.inputs.emplace_back(number, 1.0f, 2.0f, 3.0f);
        owned.inputs.emplace_back(0.0f, 10.0f, number, 30.0f);
    }
    const JobResult result = backend.run(owned.job());
    ASSERT_EQ(result.rows.size(), query_count);
    for (std::uint64_t query = 0; query < query_count; ++query) {
        const auto number = static_cast<double>(query);
        ASSERT_EQ(result.rows[query], (glm::dvec4{number, 11.0, 2.0 + number, 33.0}));
    }
}

TEST_P(EveryBackend, MovesEveryRowAcrossWorkgroupsAndDispatches) {
    // Growing and shrinking, because buffers are kept between jobs.
    for (const std::uint64_t count : {std::uint64_t{1}, kMost + 1, std::uint64_t{63},
                                      std::uint64_t{65}, kMost - 1, kMost, std::uint64_t{2}})
        expect_sums(*backend_, count);
}

TEST_P(EveryBackend, ShadesEachQueryWithItsOwnMaterial) {
    // Whole workgroups or not, and with 97 the boundary between two dispatches.
    for (const std::uint64_t queries_per_material : {1, 3, 64, 97}) {
        const std::size_t material_count = queries_per_material == 97 ? 10'900 : 1000;
        const auto scale = static_cast<double>(material_count);  // albedos are at most 1
        OwnedJob owned = make_job(Kernel::albedo, numbered_materials(material_count, scale),
                                  queries_per_material);
        owned.parameters.point_count = 1;
        const JobResult result = backend_->run(owned.job());
        for (std::size_t query = 0; query < owned.job().query_count(); ++query) {
            // The albedo of a Lambertian base is its own parameter, untouched.
            const auto material = static_cast<double>(query / queries_per_material);
            ASSERT_EQ(result.rows[3 * query + 1].x, static_cast<float>(material / scale))
                << "query " << query;
        }
    }
}

TEST_P(EveryBackend, RefusesBadJobs) {
    const std::vector<Material> materials(1);
    EXPECT_THROW(backend_->run({Model::plain, Kernel::eval, materials, 0, {}, {}}), Error);
    EXPECT_THROW(backend_->run({Model::plain, Kernel::eval, materials, 1, {}, {}}), Error);
}

INSTANTIATE_TEST_SUITE_P(Run, EveryBackend, ::testing::ValuesIn(shader_backends()),
                         backend_test_name);

}  // namespace
}  // namespace lacquer::test
