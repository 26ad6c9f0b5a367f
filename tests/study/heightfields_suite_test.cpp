// The suite `heightfields` as a user runs it, with few walks: its files, and what it finds.
#include <gmock/gmock.h>

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
using test::run_lacquer;
using test::TemporaryFolder;

const std::set<std::string> kFigures{"figure-7", "figure-9", "figure-10", "figure-11", "figure-17"};
constexpr const char* kLinear = "linear blend";

struct Run {
    TemporaryFolder folder;
    json study;

    Run() {
        const ProcessResult result =
            run_lacquer({"compare", "--suite", "heightfields", "--samples", "262144", "--json",
                         "--report", folder.path().string()});
        test::expect_success(result);
        study = json::parse(result.out);
    }
};

const Run& suite_run() {
    static const Run run;
    return run;
}

const json& figure_of(const std::string& id) {
    for (const json& figure : suite_run().study.at("figures"))
        if (figure.at("id") == id) return figure;
    throw std::runtime_error{"no " + id};
}

struct Error {
    double mean = 0.0, noise = 0.0;
};

// By subject.
std::map<std::string, Error> errors_of(const std::string& figure, const std::string& model) {
    std::map<std::string, Error> errors;
    for (const json& error : figure_of(figure).at("errors"))
        if (error.at("model") == model)
            errors[error.at("subject")] = {error.at("mean"), error.at("noise")};
    return errors;
}

TEST(HeightfieldsSuite, HasEveryFigureWithFiniteErrors) {
    std::set<std::string> ids;
    for (const json& figure : suite_run().study.at("figures")) {
        ids.insert(figure.at("id"));
        EXPECT_GT(figure.at("caption").get<std::string>().size(), 100u) << figure.at("id");
        EXPECT_FALSE(figure.at("panels").empty()) << figure.at("id");
        EXPECT_FALSE(figure.at("errors").empty()) << figure.at("id");
        for (const json& error : figure.at("errors"))
            for (const char* key : {"mean", "max", "noise"})
                EXPECT_TRUE(error.at(key).is_number()) << figure.at("id") << ' ' << error;
    }
    EXPECT_EQ(ids, kFigures);
}

// A picture of the simulation has one of the linear blend and FLIP's map of both beside it.
TEST(HeightfieldsSuite, WritesEveryPictureItNames) {
    const fs::path folder = suite_run().folder.path();
    EXPECT_EQ(json::parse(read_file(folder / "study.json")), suite_run().study);
    std::map<std::string, int> written;
    for (const json& figure : suite_run().study.at("figures"))
        for (const json& panel : figure.at("panels"))
            for (const json& row : panel.value("rows", json::array()))
                for (const json& picture : row.is_object() ? row.at("pictures") : json::array()) {
                    if (picture.is_null() || picture.at("file").is_null()) continue;
                    const std::string file = picture.at("file");
                    EXPECT_TRUE(fs::exists(folder / (file + ".png"))) << file;
                    EXPECT_TRUE(fs::exists(folder / (file + ".exr"))) << file;
                    for (const char* what : {"_simulation", "_linear_blend", "_linear_blend_FLIP"})
                        if (file.ends_with(what)) ++written[what];
                }
    EXPECT_GE(written["_simulation"], 18);
    EXPECT_EQ(written["_linear_blend"], written["_simulation"]);
    EXPECT_EQ(written["_linear_blend_FLIP"], written["_simulation"]);
}

// FLIP is in [0, 1], and sees more in the linear blend of layered surfaces than in noise, over all.
TEST(HeightfieldsSuite, FlipIsMeasuredBesideItsNoise) {
    double noise = 0.0, linear = 0.0;
    int rows = 0;
    for (const json& figure : suite_run().study.at("figures"))
        for (const json& panel : figure.at("panels")) {
            if (panel.at("kind") != "table" || panel.at("columns").at(2) != kLinear) continue;
            for (const json& row : panel.at("rows")) {
                const double one = std::stod(row.at(1).get<std::string>());
                const double other = std::stod(row.at(2).get<std::string>());
                for (const double mean : {one, other}) {
                    EXPECT_GE(mean, 0.0);
                    EXPECT_LT(mean, 1.0);
                }
                noise += one;
                linear += other;
                ++rows;
            }
        }
    EXPECT_GE(rows, 18);
    EXPECT_GT(linear, noise);
}

// Smooth facets above hide nothing, so that the blend is nearly linear; rough ones above hide the
// smooth from all sides (the paper's section 3.3.2).
TEST(HeightfieldsSuite, TheOrderOfStrataMatters) {
    const auto error_of = [](const char* figure, const char* surface) {
        for (const auto& [subject, error] : errors_of(figure, kLinear))
            if (subject.find(surface) != std::string::npos) return error;
        throw std::runtime_error{std::string{"no "} + surface};
    };
    const Error smooth_above = error_of("figure-7", "(a)"),
                rough_above = error_of("figure-7", "(b)");
    const Error blue_above = error_of("figure-17", "smooth blue above");
    const Error orange_above = error_of("figure-17", "rough orange above");
    EXPECT_LT(smooth_above.mean, rough_above.mean);
    EXPECT_LT(blue_above.mean, orange_above.mean);
    for (const Error& rough : {rough_above, orange_above}) EXPECT_GT(rough.mean, 1.5 * rough.noise);
    for (const auto& [subject, error] : errors_of("figure-10", kLinear))
        EXPECT_LT(error.mean, 1.5 * error.noise) << subject;
}

}  // namespace
}  // namespace lacquer
