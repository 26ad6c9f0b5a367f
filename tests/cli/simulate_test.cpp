// `--method simulate` of the commands that have it.
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "cli/run_lacquer.h"
#include "core/file.h"
#include "image/image_file.h"
#include "support/smooth_dielectric.h"
#include "support/temporary_folder.h"

namespace lacquer {
namespace {

using nlohmann::json;
using test::expect_failure;
using test::expect_success;
using test::kUsage;
using test::run_lacquer;
using test::TemporaryFolder;
using ::testing::HasSubstr;
using ::testing::SizeIs;

// Five standard errors: a false alarm in a million.
constexpr double kSigmas = 5.0;

constexpr double kRounding = 1e-9;  // of sums over all walks

constexpr const char* kCoated = R"({"name": "coated",
    "layers": [{"interface": {"ior": 1.5, "alpha": 0.0}}],
    "base": {"lambertian": {"albedo": [0.5, 0.25, 1.0]}}})";

constexpr const char* kRoughMirror = R"({"name": "mirror",
    "base": {"conductor": {"eta": [0, 0, 0], "kappa": [1, 1, 1], "alpha": 1.0}}})";

class Simulate : public ::testing::Test {
 protected:
    std::string material(const char* text) {
        write_file(folder_ / "material.json", text);
        return (folder_ / "material.json").string();
    }

    TemporaryFolder folder_;
};

TEST_F(Simulate, AlbedoOfASmoothCoatHasItsKnownValueAndFurnace) {
    const ProcessResult result =
        run_lacquer({"albedo", "--material", material(kCoated), "--cos", "0.5", "--method",
                     "simulate", "--samples", "200000", "--json"});
    expect_success(result);
    const json row = json::parse(result.out).at("rows").at(0);
    EXPECT_EQ(row.at("cos"), 0.5);
    EXPECT_EQ(row.at("samples"), 200000);
    // Light enters, and is then reflected by the base and kept inside by the interface in turn.
    constexpr double kEta = 1.5;
    constexpr double kRho = 0.5;
    const double inside = test::smooth_diffuse_reflectance(1.0 / kEta);
    const double expected =
        (1.0 - test::smooth_reflectance(0.5, kEta)) * kRho * (1.0 - inside) / (1.0 - kRho * inside);
    EXPECT_NEAR(row.at("base").at(0).get<double>(), expected,
                kSigmas * row.at("stderr").at("base").at(0).get<double>());
    EXPECT_NEAR(row.at("total").at(2).get<double>(), 1.0, kRounding);
    EXPECT_EQ(row.at("transmitted").at(0), 0.0);
    EXPECT_FALSE(row.contains("orders"));  // there are several surfaces
}

TEST_F(Simulate, AlbedoOfOneSurfaceIsSplitByOrder) {
    constexpr const char* kInterface = R"({"name": "glass",
        "layers": [{"interface": {"ior": 1.5, "alpha": 0.8}}], "base": "none"})";
    for (const char* text : {kInterface, kRoughMirror, test::kLambertian}) {
        const ProcessResult result =
            run_lacquer({"albedo", "--material", material(text), "--cos", "0.5,0.2", "--method",
                         "simulate", "--samples", "50000", "--json"});
        expect_success(result);
        const json rows = json::parse(result.out).at("rows");
        ASSERT_THAT(rows, SizeIs(2));
        for (const json& row : rows) {
            const json& orders = row.at("orders");
            EXPECT_EQ(orders.at("all"), row.at("total"));
            EXPECT_EQ(row.at("stderr").at("orders").at("all"), row.at("stderr").at("total"));
            double sum = 0.0;
            for (const char* order : {"1", "2", "3"}) sum += orders.at(order).at(0).get<double>();
            EXPECT_LE(sum, orders.at("all").at(0).get<double>() + kRounding);
            EXPECT_GT(sum, 0.0);
        }
    }
}

TEST_F(Simulate, AlbedoPrintsATableWithStandardErrors) {
    const ProcessResult result =
        run_lacquer({"albedo", "--material", material(test::kLambertian), "--cos", "1", "--method",
                     "simulate", "--samples", "1000"});
    expect_success(result);
    EXPECT_THAT(result.out, HasSubstr("standard error"));
    EXPECT_THAT(result.out, HasSubstr("0.50000 0.25000 1.00000"));
}

TEST_F(Simulate, SingleScatteringLosesWhatMeetsMoreFacets) {
    const auto total = [&](const char* orders) {
        const ProcessResult result =
            run_lacquer({"albedo", "--material", material(kRoughMirror), "--cos", "0.5", "--method",
                         "simulate", "--samples", "50000", "--orders", orders, "--json"});
        expect_success(result);
        return json::parse(result.out).at("rows").at(0);
    };
    const json all = total("all");
    const json single = total("1");
    EXPECT_NEAR(all.at("total").at(0).get<double>(), 1.0, kRounding);
    EXPECT_LT(single.at("total").at(0).get<double>(), 0.9);
    EXPECT_EQ(single.at("total"), single.at("orders").at("1"));
    EXPECT_EQ(single.at("total"), all.at("orders").at("1"));
}

TEST_F(Simulate, ResultsRepeatForOneSeedAndDifferForAnother) {
    const auto albedo = [&](const char* seed) {
        return run_lacquer({"albedo", "--material", material(kCoated), "--cos", "0.5", "--method",
                            "simulate", "--samples", "20000", "--seed", seed, "--json"})
            .out;
    };
    const std::string once = albedo("1");
    EXPECT_EQ(once, albedo("1"));
    EXPECT_NE(once, albedo("2"));
}

TEST_F(Simulate, SliceOfALambertianSurfaceIsItsBsdf) {
    const std::string output = (folder_ / "slice.exr").string();
    expect_success(run_lacquer({"slice", "--material", material(test::kLambertian), "--method",
                                "simulate", "--size", "16", "--samples", "400000", "-o", output}));
    const auto picture = decode_exr(read_file(output), output);
    EXPECT_EQ(picture.metadata.at("estimator"), "histogram");
    EXPECT_EQ(picture.metadata.at("samples"), "400000");
    // Each pixel near the normal counts about 400000 * 8 / 16^2 / pi walks.
    const double error = std::sqrt(std::numbers::pi * 16 * 16 / 8 / 400000);
    for (int y = 5; y < 11; ++y)
        for (int x = 5; x < 11; ++x)
            EXPECT_NEAR(picture.image.at(x, y).z * std::numbers::pi, 1.0, kSigmas * 1.3 * error);
    EXPECT_EQ(picture.image.at(0, 0).w, 0.0f);
}

TEST_F(Simulate, SliceOfOneRoughSurfaceSaysThatItUsesNextEventEstimates) {
    const std::string output = (folder_ / "slice.exr").string();
    expect_success(run_lacquer({"slice", "--material", material(kRoughMirror), "--method",
                                "simulate", "--size", "8", "--samples", "10000", "-o", output}));
    EXPECT_EQ(decode_exr(read_file(output), output).metadata.at("estimator"), "next event");
}

TEST_F(Simulate, OptionsOfTheOtherMethodAreRefused) {
    const std::string coated = material(kCoated);
    expect_failure(run_lacquer({"albedo", "--material", coated, "--cos", "1", "--seed", "3"}),
                   kUsage, {"--seed", "simulate"});
    expect_failure(run_lacquer({"albedo", "--material", coated, "--cos", "1", "--method",
                                "simulate", "--backend", "cpp"}),
                   kUsage, {"--backend", "model"});
    expect_failure(run_lacquer({"albedo", "--material", coated, "--cos", "1", "--method",
                                "simulate", "--orders", "2"}),
                   kUsage, {"--orders"});
    expect_failure(run_lacquer({"albedo", "--material", coated, "--cos", "1", "--method",
                                "simulate", "--samples", "0"}),
                   kUsage, {"--samples", "0"});
    expect_failure(run_lacquer({"slice", "--material", coated, "--samples", "9", "-o",
                                (folder_ / "x.exr").string()}),
                   kUsage, {"--samples", "simulate", "model"});
    expect_failure(run_lacquer({"slice", "--material", coated, "--method", "simulate", "--size",
                                "2048", "-o", (folder_ / "x.exr").string()}),
                   kUsage, {"--size", "2048", "1024"});
}

}  // namespace
}  // namespace lacquer
