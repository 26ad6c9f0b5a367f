#include <gmock/gmock.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "compare/fake_backend.h"
#include "core/file.h"
#include "image/exr.h"
#include "report/folder.h"
#include "report/html.h"
#include "report/json.h"
#include "report/junit.h"
#include "markup/markup.h"
#include "report/text.h"
#include "support/temporary_folder.h"

namespace lacquer {
namespace {

using namespace test;
using nlohmann::json;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::SizeIs;

CompareResult every_outcome() {
    CompareRequest request = small_request({&kRight, &kWrong, &kNotANumber, &kMissing, &kCrashing});
    request.keep_values = true;
    return run_compare(request);
}

TEST(CompareJson, HasTheDocumentedShape) {
    const json parsed = json::parse(compare_json(every_outcome()));
    const json& backends = parsed.at("backends");
    ASSERT_THAT(backends, SizeIs(5));
    const std::vector<std::string> statuses{"passed", "failed", "failed", "skipped", "failed"};
    for (std::size_t i = 0; i < statuses.size(); ++i) {
        EXPECT_EQ(backends[i].at("status"), statuses[i]);
        EXPECT_EQ(backends[i].at("reason").get<std::string>().empty(), statuses[i] == "passed");
        EXPECT_TRUE(backends[i].at("materials").is_array());
    }
    const json& material = backends[1].at("materials")[1];
    EXPECT_EQ(material.at("name"), "second");
    for (const char* key : {"queries", "max_abs", "mean_abs", "max_rel", "p999_rel", "median_rel",
                            "queries_per_second"})
        EXPECT_TRUE(material.at(key).is_number()) << key;
    EXPECT_THAT(material.at("worst").at("wi"), SizeIs(3));
    EXPECT_THAT(material.at("worst").at("wo"), SizeIs(3));
}

TEST(CompareJson, KeepsTheWorstQueryToTheLastBit) {
    const CompareResult result = every_outcome();
    const json parsed = json::parse(compare_json(result));
    const json& wi = parsed["backends"][1]["materials"][1]["worst"]["wi"];
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_EQ(wi[static_cast<std::size_t>(axis)].get<float>(),
                  result.backends[1].materials[1].worst.query.wi[axis]);
}

TEST(CompareJson, WritesNullForWhatIsNotFinite) {
    const json parsed = json::parse(compare_json(every_outcome()));
    const json& material = parsed["backends"][2]["materials"][0];
    EXPECT_TRUE(material.at("max_rel").is_null());
    EXPECT_EQ(material.at("non_finite"), 2);  // one query on each of two grids
}

TEST(CompareJunit, IsWellFormedAndCountsEveryOutcome) {
    std::istringstream text{compare_junit(every_outcome())};
    boost::property_tree::ptree tree;
    boost::property_tree::read_xml(text, tree);
    std::vector<std::string> counts;
    for (const auto& [name, suite] : tree.get_child("testsuites")) {
        if (name != "testsuite") continue;
        const auto attribute = [&s = suite](const char* key) {
            return s.get<std::string>(std::string{"<xmlattr>."} + key);
        };
        EXPECT_EQ(suite.count("testcase"), 2u);
        counts.push_back(attribute("tests") + attribute("failures") + attribute("errors") +
                         attribute("skipped"));
    }
    EXPECT_THAT(counts, ::testing::ElementsAre("2000", "2100", "2100", "2002", "2020"));
}

TEST(CompareJunit, NamesTheFailedQuery) {
    const CompareResult result = every_outcome();
    EXPECT_THAT(compare_junit(result),
                HasSubstr(exact_text(result.backends[1].materials[1].worst.query.wi)));
}

TEST(SummaryTable, HasOneLinePerBackend) {
    const std::string table = summary_table(every_outcome());
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 6);
    EXPECT_THAT(table, HasSubstr("no driver <here>; install one"));
}

TEST(AccuracyMarkdown, LeavesOutWhatDidNotRunAndReplacesOnlyItsPlace) {
    const TemporaryFolder folder;
    const std::string before = "# Title\n", after = "\nMore.\n";
    const std::string markers = std::string{kMarkdownBegin} + "\nold\n" + std::string{kMarkdownEnd};
    write_file(folder / "README.md", before + markers + after);
    const std::string table = accuracy_markdown(every_outcome());
    EXPECT_THAT(table, Not(HasSubstr("missing")));
    update_markdown(folder / "README.md", table);
    update_markdown(folder / "README.md", table);
    EXPECT_EQ(read_file(folder / "README.md"), before + std::string{kMarkdownBegin} + "\n" + table +
                                                   std::string{kMarkdownEnd} + after);
}

TEST(AccuracyMarkdown, RefusesAFileWithoutItsPlace) {
    const TemporaryFolder folder;
    write_file(folder / "README.md", "# Title\n");
    EXPECT_THROW(update_markdown(folder / "README.md", "x"), Error);
    EXPECT_EQ(read_file(folder / "README.md"), "# Title\n");
}

TEST(ReportHtml, AsksForNothingFromOutside) {
    const std::string html = report_html(every_outcome(), {"<cpu>", "system", "today"});
    for (const char* outside : {"http:", "https:", "src=\"/", "@import", "<script", "<link"})
        EXPECT_THAT(html, Not(HasSubstr(outside))) << outside;
    EXPECT_THAT(html, HasSubstr("&lt;cpu&gt;"));
}

TEST(ReportHtml, ShowsEveryBackendAndMaterialWithReasonsAndReplays) {
    const CompareResult result = every_outcome();
    const std::string html = report_html(result, {"cpu", "system", "today"});
    for (const BackendResult& backend : result.backends) EXPECT_THAT(html, HasSubstr(backend.name));
    EXPECT_THAT(html, HasSubstr("the first &amp; only"));
    EXPECT_THAT(html, HasSubstr("no driver &lt;here&gt;"));
    EXPECT_THAT(
        html,
        HasSubstr(escaped(replay_command(result.backends[1], result.backends[1].materials[1]))));
}

TEST(ReportHtml, NeedsTheValuesToDraw) {
    const CompareResult result = run_compare(small_request({&kRight}));
    EXPECT_THROW(report_html(result, {}), Error);
}

TEST(WriteReport, WritesEveryFileAndTheFailedSlices) {
    const TemporaryFolder folder;
    write_report(every_outcome(), folder / "report");
    const auto exists = [&](const char* name) {
        return std::filesystem::exists(folder / "report" / name);
    };
    EXPECT_TRUE(exists("report.html"));
    EXPECT_TRUE(exists("compare.json"));
    EXPECT_TRUE(exists("junit.xml"));
    EXPECT_TRUE(exists("exr/second/reference_sphere.exr"));
    EXPECT_TRUE(exists("exr/second/wrong_slice_30.exr"));
    EXPECT_FALSE(exists("exr/first/wrong_slice_30.exr"));
}

TEST(WriteReport, NotesInEachPictureWhatItShows) {
    const TemporaryFolder folder;
    write_report(every_outcome(), folder.path());
    const std::filesystem::path file = folder / "exr/second/wrong_sphere.exr";
    const Metadata metadata = decode_exr(read_file(file), file.string()).metadata;
    EXPECT_THAT(metadata, Contains(std::pair<const std::string, std::string>{"backend", "wrong"}));
    EXPECT_THAT(metadata,
                Contains(std::pair<const std::string, std::string>{"material", "second"}));
}

TEST(WriteReport, IntoAFileIsAnError) {
    const TemporaryFolder folder;
    write_file(folder / "taken", "");
    EXPECT_THROW(require_report_folder(folder / "taken"), Error);
}

// RFC 4648, section 10.
TEST(PngDataUri, MeetsTheStandardsExamples) {
    EXPECT_EQ(png_data_uri("f"), "data:image/png;base64,Zg==");
    EXPECT_EQ(png_data_uri("fo"), "data:image/png;base64,Zm8=");
    EXPECT_EQ(png_data_uri("foobar"), "data:image/png;base64,Zm9vYmFy");
}

}  // namespace
}  // namespace lacquer
