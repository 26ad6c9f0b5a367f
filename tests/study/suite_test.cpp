// The suite `diffuse-interfaces` as a user runs it, with few walks: its files, and what it finds.
#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "cli/run_lacquer.h"
#include "core/file.h"
#include "support/temporary_folder.h"

namespace lacquer {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::expect_failure;
using test::kFailure;
using test::kUsage;
using test::run_lacquer;
using test::TemporaryFolder;
using ::testing::IsEmpty;

const std::set<std::string> kFigures{"figure-3",  "figure-4",      "figure-5",
                                     "figure-7",  "figure-8",      "figure-9",
                                     "figure-11", "white-furnace", "random-materials"};
const std::vector<std::string> kBaselines{"openpbr-coat", "clearcoat", "weidlich-wilkie", "plain"};
constexpr const char* kSuite = "diffuse-interfaces";

struct Run {
    TemporaryFolder folder;
    json study;

    Run() {
        const ProcessResult result =
            run_lacquer({"compare", "--suite", kSuite, "--samples", "262144", "--json", "--report",
                         folder.path().string()});
        test::expect_success(result);
        study = json::parse(result.out);
    }
};

const Run& suite_run() {
    static const Run run;
    return run;
}

// Over all parts of a figure.
struct Error {
    double mean = 0.0, noise = 0.0;
    int parts = 0;
};

Error error_of(const json& figure, const std::string& model) {
    Error error;
    for (const json& part : figure.at("errors")) {
        if (part.at("model") != model) continue;
        error.mean += part.at("mean").get<double>();
        error.noise += part.at("noise").get<double>();
        ++error.parts;
    }
    error.mean /= error.parts;
    error.noise /= error.parts;
    return error;
}

const json& figure_of(const std::string& id) {
    for (const json& figure : suite_run().study.at("figures"))
        if (figure.at("id") == id) return figure;
    throw std::runtime_error{"no " + id};
}

TEST(DiffuseInterfacesSuite, HasEveryFigureWithFiniteErrors) {
    std::set<std::string> ids;
    for (const json& figure : suite_run().study.at("figures")) {
        ids.insert(figure.at("id"));
        EXPECT_FALSE(figure.at("panels").empty()) << figure.at("id");
        EXPECT_FALSE(figure.at("errors").empty()) << figure.at("id");
        for (const json& error : figure.at("errors"))
            for (const char* key : {"mean", "max", "noise"})
                EXPECT_TRUE(error.at(key).is_number()) << figure.at("id") << ' ' << error;
    }
    EXPECT_EQ(ids, kFigures);
}

TEST(DiffuseInterfacesSuite, WritesEveryPictureItNames) {
    const fs::path folder = suite_run().folder.path();
    EXPECT_EQ(json::parse(read_file(folder / "study.json")), suite_run().study);
    int pictures = 0;
    for (const json& figure : suite_run().study.at("figures"))
        for (const json& panel : figure.at("panels"))
            for (const json& row : panel.value("rows", json::array()))
                for (const json& picture : row.is_object() ? row.at("pictures") : json::array()) {
                    if (picture.is_null()) continue;
                    const std::string file = picture.at("file");
                    EXPECT_TRUE(fs::exists(folder / (file + ".png"))) << file;
                    EXPECT_TRUE(fs::exists(folder / (file + ".exr"))) << file;
                    ++pictures;
                }
    EXPECT_GT(pictures, 100);
    EXPECT_GT(fs::file_size(folder / "report.html"), 1'000'000u);
}

// In every figure the model of all light is nearer to the simulation than those that leave some
// out. The noise, which it has in common with them, is no help to it.
TEST(DiffuseInterfacesSuite, ExactIsNearerThanTheBaselines) {
    for (const std::string& id : kFigures)
        for (const std::string& baseline : kBaselines)
            EXPECT_LT(error_of(figure_of(id), "coated-exact").mean,
                      error_of(figure_of(id), baseline).mean)
                << id << ", " << baseline;
}

// What is left of a mean |error| when noise of size `noise` is taken away: for normal noise n,
// E|x + n| <= |x| + E|n|. Noise itself is known to a tenth: few walks make its estimate.
double sure(const Error& error) {
    return error.mean - 1.1 * error.noise;
}

TEST(DiffuseInterfacesSuite, ExactKeepsItsPromises) {
    constexpr double kMeanAlbedo = 0.002, kDistance = 0.01, kFurnace = 0.003;
    EXPECT_LE(sure(error_of(figure_of("random-materials"), "coated-exact")), kMeanAlbedo);
    EXPECT_LE(sure(error_of(figure_of("figure-3"), "coated-exact")), kMeanAlbedo);
    EXPECT_LE(sure(error_of(figure_of("figure-3"), "tables")), kMeanAlbedo);
    EXPECT_LE(sure(error_of(figure_of("figure-11"), "coated-exact")), kDistance);
    for (const json& error : figure_of("white-furnace").at("errors"))
        if (error.at("model") == "coated-exact") {
            EXPECT_LE(error.at("max"), kFurnace);
        }
}

// Dense coats, whose light seldom meets several facets: the mean error of a picture is that of
// albedos, over pictures whose mean is at least 0.2.
TEST(DiffuseInterfacesSuite, ExactPicturesOfDenseCoats) {
    constexpr double kPicture = 0.002 / 0.2;
    for (const char* id : {"figure-8", "figure-9"})
        EXPECT_LE(sure(error_of(figure_of(id), "coated-exact")), kPicture) << id;
}

TEST(DiffuseInterfacesSuite, EachBasisFunctionIsWorthSomething) {
    double before = 0.0;
    for (const char* kept : {"5 functions of tau", "4 functions of tau", "3 functions of tau",
                             "2 functions of tau", "1 function of tau"})
        for (const json& error : figure_of("figure-5").at("errors"))
            if (error.at("model") == kept && error.at("subject") == "T01") {
                EXPECT_GT(error.at("mean"), before) << kept;
                before = error.at("mean");
            }
    EXPECT_GT(before, 0.01);
}

TEST(SuiteUsage, OptionsOfTheOtherKindOfSuiteAreRefused) {
    for (const auto& [option, value] : {std::pair{"--backend", "cpp"},
                                        {"--material", "gold"},
                                        {"--model", "plain"},
                                        {"--device", "0"},
                                        {"--update-readme", "README.md"}})
        expect_failure(run_lacquer({"compare", "--suite", kSuite, option, value}), kUsage,
                       {option, kSuite});
    expect_failure(run_lacquer({"compare", "--samples", "10"}), kUsage, {"--samples", "default"});
    expect_failure(run_lacquer({"compare", "--suite", "huge"}), kUsage,
                   {"huge", "default", kSuite});
    for (const char* samples : {"0", "-1", "4095", "many"})
        expect_failure(run_lacquer({"compare", "--suite", kSuite, "--samples", samples}), kUsage,
                       {"--samples", samples});
}

TEST(SuiteUsage, AFolderThatCannotBeWrittenIsSaidBeforeAnythingIsComputed) {
    const TemporaryFolder folder;
    write_file(folder / "file", "");
    // Were it to compute first, it would not end within the test's time.
    expect_failure(run_lacquer({"compare", "--suite", kSuite, "--samples", "1000000000000",
                                "--report", (folder / "file/report").string()}),
                   kFailure, {"file/report"});
    EXPECT_THAT(folder.entries(), ::testing::ElementsAre("file"));
}

}  // namespace
}  // namespace lacquer
