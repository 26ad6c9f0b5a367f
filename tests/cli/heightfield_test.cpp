// `lacquer heightfield`: its numbers, its report, and what it refuses.
#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/run_lacquer.h"
#include "core/file.h"
#include "image/image_file.h"
#include "support/temporary_folder.h"

namespace lacquer {
namespace {

using nlohmann::json;
using test::expect_failure;
using test::expect_success;
using test::kFailure;
using test::kUsage;
using test::run_lacquer;
using test::TemporaryFolder;
using test::Words;
using ::testing::HasSubstr;

// Mirrors whose upper half is rougher.
constexpr const char* kEroded =
    R"({"name": "eroded", "base": {"conductor": {"eta": [0, 0, 0], "kappa": [1, 1, 1],
        "blend": {"operator": "asymmetric", "strata": [
            {"weight": 0.5, "alpha": 0.91, "ndf": "beckmann"},
            {"alpha": 0.364, "ndf": "beckmann"}]}}}})";

class HeightfieldCommand : public ::testing::Test {
 protected:
    ProcessResult run(const Words& options, const std::string& material = kEroded) {
        write_file(folder_ / "material.json", material);
        Words words{"heightfield", "--material", (folder_ / "material.json").string()};
        for (const auto& [option, value] : {std::pair{"--grid", "64"},
                                            {"--correlation", "8"},
                                            {"--realisations", "2"},
                                            {"--samples", "2000"}})
            if (std::ranges::find(options, option) == options.end())
                words.insert(words.end(), {option, value});
        words.insert(words.end(), options.begin(), options.end());
        return run_lacquer(words);
    }

    TemporaryFolder folder_;
};

TEST_F(HeightfieldCommand, PrintsTheOrdersOfBothWays) {
    const ProcessResult result = run({"--theta", "0.3,1.2", "--orders", "2", "--json"});
    expect_success(result);
    const json found = json::parse(result.out);
    EXPECT_EQ(found.at("material"), "eroded");
    ASSERT_EQ(found.at("rows").size(), 2u);
    for (const json& row : found.at("rows"))
        for (const char* way : {"heightfield", "smith"}) {
            const json& orders = row.at(way).at("orders");
            ASSERT_EQ(orders.size(), 4u);  // 1, 2, more, all
            double sum = 0.0;
            for (const char* order : {"1", "2", "more"})
                sum += orders.at(order).at(0).get<double>();
            // Mirrors return all light; single rays may be lost between facets.
            EXPECT_NEAR(sum, 1.0, 1e-3);
            EXPECT_NEAR(orders.at("all").at(1).get<double>(), sum, 1e-9);
            EXPECT_GT(row.at(way).at("stderr").at("orders").at("1").at(0).get<double>(), 0.0);
        }
}

TEST_F(HeightfieldCommand, TheSameSeedGivesTheSameBytes) {
    const ProcessResult first = run({"--seed", "5", "--json"}),
                        again = run({"--seed", "5", "--json"});
    expect_success(first);
    EXPECT_EQ(first.out, again.out);
    EXPECT_NE(first.out, run({"--seed", "6", "--json"}).out);
}

TEST_F(HeightfieldCommand, WritesAReport) {
    const auto report = folder_ / "report";
    expect_success(run({"--theta", "0.75", "--size", "16", "--report", report.string()}));
    const std::string page = read_file(report / "report.html");
    EXPECT_THAT(page, HasSubstr("eroded"));
    EXPECT_THAT(page, HasSubstr("theta 0.75"));
    const auto pictures = report / "pictures" / "surface";
    const Image surface = read_image(pictures / "surface.png");
    EXPECT_GT(surface.width, 0);
    for (const char* order : {"order_1", "order_2", "order_3", "order_4", "all"})
        for (const char* what : {"heightfield", "smith", "difference"}) {
            const std::string name = std::string{"theta_0.75_"} + order + "_" + what;
            EXPECT_EQ(read_image(pictures / (name + ".exr")).width, 16) << name;
            EXPECT_EQ(read_image(pictures / (name + ".png")).width, 16) << name;
        }
    const json study = json::parse(read_file(report / "study.json"));
    EXPECT_EQ(study.at("figures").at(0).at("errors").at(0).at("model"), "Smith's theory");
}

TEST_F(HeightfieldCommand, NumbersOutOfRangeNameIt) {
    for (const auto& [option, value, limit] : {std::tuple{"--theta", "45", "1.57"},
                                               {"--theta", "-0.1", "[0"},
                                               {"--orders", "0", "[1, 8]"},
                                               {"--grid", "16", "[32, 4096]"},
                                               {"--correlation", "17", "[4, 16]"},
                                               {"--realisations", "1", "[2, 4096]"},
                                               {"--size", "4", "[8, 512]"},
                                               {"--samples", "0", "[1, "}})
        expect_failure(run({option, value}), kUsage, {option, value, limit});
}

TEST_F(HeightfieldCommand, MaterialsWithoutAHeightfieldAreRefused) {
    const std::string ggx = R"({"name": "metal", "base": {"conductor": {"metal": "gold",
        "alpha": 0.3}}})";
    expect_failure(run({}, ggx), kFailure, {"'metal'", "/base/conductor/ndf", "beckmann"});
    expect_failure(run({"--report", (folder_ / "report").string()}, test::kLambertian), kFailure,
                   {"'matte'", "diffuse_facets"});
}

}  // namespace
}  // namespace lacquer
