// The files of a study: every kind of panel, and numbers that are none.
#include <gmock/gmock.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "core/file.h"
#include "image/image_file.h"
#include "study/errors.h"
#include "study/folder.h"
#include "study/json.h"
#include "study/page.h"
#include "study/summary.h"
#include "support/temporary_folder.h"

namespace lacquer::study {
namespace {

using nlohmann::json;
using test::TemporaryFolder;
using ::testing::HasSubstr;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Figure sample_figure() {
    Image image{2, 1};
    image.at(0, 0) = {0.25f, 0.5f, 1.0f, 1.0f};
    Figure figure{"figure-1", "A < B", "what & why", "mean |error|"};
    figure.panels.emplace_back(
        PictureTable{"pictures",
                     {"simulation", "model"},
                     {{"sphere", {{"truth", image}, {"model", image, 0.5, "3 % off"}}},
                      {"none", {{}, {.name = {}, .note = "shades < 2"}}}}});
    figure.panels.emplace_back(
        Plots{"plots", {{"curve", "x", "y", 0, 1, 0, 1, {{"a", {0, 1}, {0.5, kNan}}}}}});
    figure.panels.emplace_back(
        Maps{"maps", {{{"map", "x", "y", 0, 1, 0, 2, {}}, {"map", image, 0.1}}}});
    figure.panels.emplace_back(NumberTable{"table", {"a", "b"}, {{"1", "2"}}});
    figure.errors = {{"one", "good", 0.1, 0.2, 0.01, "here"},
                     {"two", "good", 0.3, 0.9, 0.03, "there"},
                     {"one", "bad", kNan, 2.0, 0.0, "<there>"}};
    return figure;
}

constexpr Suite kSuite{"sample", "A sample & more", "Nobody 2000", "summary", {}};

StudyResult sample_result() {
    return {&kSuite, 1000, 7, 1.5, {sample_figure(), sample_figure()}};
}

TEST(StudyJson, HasAllPanelsAndErrors) {
    const json study = json::parse(study_json(sample_result()));
    EXPECT_EQ(study.at("suite"), "sample");
    EXPECT_EQ(study.at("samples"), 1000);
    const json& figure = study.at("figures").at(0);
    EXPECT_EQ(figure.at("errors").at(1).at("max"), 0.9);
    EXPECT_TRUE(figure.at("errors").at(2).at("mean").is_null());
    const json& panels = figure.at("panels");
    ASSERT_EQ(panels.size(), 4u);
    EXPECT_EQ(panels[0].at("rows").at(0).at("pictures").at(0).at("file"),
              "pictures/figure-1/truth");
    EXPECT_TRUE(panels[0].at("rows").at(1).at("pictures").at(0).is_null());
    const json& absent = panels[0].at("rows").at(1).at("pictures").at(1);
    EXPECT_TRUE(absent.at("file").is_null());
    EXPECT_EQ(absent.at("note"), "shades < 2");
    EXPECT_TRUE(panels[1].at("plots").at(0).at("curves").at(0).at("y").at(1).is_null());
    EXPECT_EQ(panels[2].at("maps").at(0).at("values").at(0).at(0), 0.25);
    EXPECT_EQ(panels[3].at("rows").at(0).at(1), "2");
}

TEST(StudyPage, EscapesItsTextAndHoldsItsPictures) {
    const std::string page = page_html(sample_result());
    for (const char* part :
         {"A &lt; B", "what &amp; why", "A sample &amp; more", "&lt;there&gt;", "shades &lt; 2",
          "data:image/png;base64,", "<svg class=\"plot\"", "3 % off", "</html>"})
        EXPECT_THAT(page, HasSubstr(part));
}

TEST(StudyFolder, WritesPicturesAsNumbersAndForDisplay) {
    const TemporaryFolder folder;
    write_study(sample_result(), folder.path());
    EXPECT_THAT(folder.entries(), ::testing::ElementsAre("pictures", "report.html", "study.json"));
    const Image numbers = read_image(folder / "pictures/figure-1/model.exr");
    EXPECT_EQ(numbers.at(0, 0), (glm::vec4{0.25f, 0.5f, 1.0f, 1.0f}));
    // A difference of half the limit and one of more than all of it look different.
    EXPECT_NE(read_file(folder / "pictures/figure-1/model.png"),
              read_file(folder / "pictures/figure-1/map.png"));
    EXPECT_EQ(read_image(folder / "pictures/figure-1/truth.png").width, 2);
}

TEST(StudySummary, AveragesTheMeansAndKeepsTheWorst) {
    const auto good = overall_error(sample_figure(), "good");
    ASSERT_TRUE(good);
    EXPECT_DOUBLE_EQ(good->mean, 0.2);
    EXPECT_DOUBLE_EQ(good->noise, 0.02);
    EXPECT_EQ(good->subject, "two");
    EXPECT_FALSE(overall_error(sample_figure(), "absent"));
    EXPECT_THAT(common_models(sample_result()), ::testing::ElementsAre("good", "bad"));
    EXPECT_THAT(summary_text(sample_result()), HasSubstr("two: there"));
}

}  // namespace
}  // namespace lacquer::study
