// Ctrl-C keeps what a simulation has done. Every command here asks for more walks than there is
// time for.
#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/interrupt.h"
#include "core/file.h"
#include "image/image_file.h"
#include "support/temporary_folder.h"

namespace lacquer {
namespace {

using nlohmann::json;
using test::expect_success;
using test::interrupt_lacquer;
using test::TemporaryFolder;
using ::testing::HasSubstr;
using ::testing::SizeIs;

constexpr const char* kManyWalks = "1000000000000";
constexpr double kRounding = 1e-9;

void expect_some_walks(const ProcessResult& result, std::uint64_t walks) {
    expect_success(result);
    EXPECT_GT(walks, 0u);
    EXPECT_LT(walks, std::stoull(kManyWalks));
    EXPECT_THAT(result.err, HasSubstr("stopped after " + std::to_string(walks) + " of"));
}

TEST(Interrupt, AlbedoPrintsTheRowsItHasBegun) {
    const TemporaryFolder folder;
    write_file(folder / "material.json", R"({"name": "furnace",
        "layers": [{"interface": {"ior": 1.5, "alpha": 0.5}}],
        "base": {"lambertian": {"albedo": [1, 1, 1]}}})");
    const ProcessResult result =
        interrupt_lacquer({"albedo", "--material", folder / "material.json", "--cos", "0.5,1",
                           "--method", "simulate", "--samples", kManyWalks, "--json"});
    const json rows = json::parse(result.out).at("rows");
    ASSERT_THAT(rows, SizeIs(1));
    expect_some_walks(result, rows[0].at("samples"));
    EXPECT_EQ(rows[0].at("cos"), 0.5);
    EXPECT_NEAR(rows[0].at("total")[1].get<double>(), 1.0, kRounding);
}

TEST(Interrupt, InterfacePrintsItsEstimate) {
    const ProcessResult result =
        interrupt_lacquer({"interface", "--alpha", "0.5", "--eta", "1.5", "--tau", "1", "--cos",
                           "0.5", "--method", "simulate", "--samples", kManyWalks, "--json"});
    const json values = json::parse(result.out);
    expect_some_walks(result, values.at("samples"));
    EXPECT_NEAR(values.at("T01").get<double>() + values.at("FGD").get<double>(), 1.0, kRounding);
}

TEST(Interrupt, SliceWritesItsPicture) {
    const TemporaryFolder folder;
    const std::string output = folder / "slice.exr";
    const ProcessResult result =
        interrupt_lacquer({"slice", "--material", "porcelain", "--method", "simulate", "--size",
                           "8", "--samples", kManyWalks, "-o", output});
    const auto picture = decode_exr(read_file(output), output);
    expect_some_walks(result, std::stoull(picture.metadata.at("samples")));
    EXPECT_GT(picture.image.at(4, 4).x, 0.0f);
}

}  // namespace
}  // namespace lacquer
