// What users get wrong: each case ends with the documented exit code and a message that says what
// is wrong, where, and what would be right, and writes nothing.
#include <gmock/gmock.h>

#include "cli/run_lacquer.h"
#include "core/environment.h"
#include "core/file.h"
#include "image/exr.h"
#include "support/temporary_folder.h"

namespace lacquer {
namespace {

using test::expect_failure;
using test::kFailure;
using test::kUsage;
using test::run_lacquer;
using test::TemporaryFolder;
using test::Words;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr const char* kQuery = "wi_x,wi_y,wi_z,wo_x,wo_y,wo_z\n0,0,1,0,0,1\n";

TEST(BadUsage, NoCommandListsTheCommands) {
    expect_failure(run_lacquer({}), kUsage, {"command", "compare", "eval", "doctor"});
}

TEST(BadUsage, AnUnknownCommandIsNamedAndTheCommandsListed) {
    expect_failure(run_lacquer({"evaluate"}), kUsage, {"evaluate", "compare", "eval"});
}

TEST(BadUsage, AnUnknownOptionIsNamed) {
    expect_failure(run_lacquer({"compare", "--frobnicate"}), kUsage,
                   {"--frobnicate", "lacquer compare --help"});
}

TEST(BadUsage, AMissingRequiredOptionIsNamed) {
    expect_failure(run_lacquer({"eval", "--material", "gold"}), kUsage, {"--queries"});
}

TEST(BadUsage, UnknownNamesListThoseThereAre) {
    const Words eval{"eval", "--queries", "-"};
    const auto with = [&](Words words) {
        words.insert(words.begin(), eval.begin(), eval.end());
        return run_lacquer(words, kQuery);
    };
    expect_failure(with({"--material", "gold", "--backend", "cuda"}), kUsage,
                   {"cuda", "reference", "vulkan"});
    expect_failure(with({"--material", "gold", "--model", "phong"}), kUsage, {"phong", "plain"});
    expect_failure(with({"--material", "unobtainium"}), kUsage, {"unobtainium", "gold", "glass"});
    expect_failure(run_lacquer({"compare", "--suite", "huge"}), kUsage, {"huge", "default"});
    expect_failure(run_lacquer({"albedo", "--material", "gold", "--cos", "1", "--method", "guess"}),
                   kUsage, {"guess", "model"});
}

TEST(BadUsage, QueryCountsOutsideTheRangeNameIt) {
    for (const char* count : {"0", "2147483648", "134217729"})
        expect_failure(run_lacquer({"bench", "--queries", count}), kUsage,
                       {"--queries", count, "134217728"});
    for (const char* count : {"-1", "many", "1e99"})
        expect_failure(run_lacquer({"bench", "--queries", count}), kUsage, {"--queries", count});
}

TEST(BadUsage, ChoicesOfAnExportOutsideTheirRangeNameIt) {
    const TemporaryFolder folder;
    const std::string output = (folder / "shaders").string();
    for (const char* layers : {"0", "33", "-8"})
        expect_failure(run_lacquer({"export", "--max-layers", layers, "-o", output}), kUsage,
                       {"--max-layers", layers, "[1, 32]"});
    for (const char* lobes : {"1", "4"})
        expect_failure(run_lacquer({"export", "--stack-lobes", lobes, "-o", output}), kUsage,
                       {"--stack-lobes", lobes, "[2, 3]"});
    for (const char* option : {"--max-layers", "--stack-lobes"})
        expect_failure(run_lacquer({"export", option, "many", "-o", output}), kUsage,
                       {option, "many"});
    expect_failure(run_lacquer({"export", "--level", "plain", "--max-layers", "2", "-o", output}),
                   kUsage, {"--max-layers", "stack_symmetric"});
    EXPECT_THAT(folder.entries(), IsEmpty());
}

TEST(BadUsage, NumbersOutsideTheirRangeNameIt) {
    const TemporaryFolder folder;
    const std::string output = (folder / "x.exr").string();
    const Words slice{"slice", "--material", "gold", "-o", output};
    const auto with = [&](Words words) {
        words.insert(words.begin(), slice.begin(), slice.end());
        return run_lacquer(words);
    };
    expect_failure(with({"--wo-theta", "91"}), kUsage, {"--wo-theta", "91", "90"});
    expect_failure(with({"--wo-theta", "nan"}), kUsage, {"--wo-theta", "nan"});
    expect_failure(with({"--size", "0"}), kUsage, {"--size", "8192"});
    expect_failure(with({"--size", "100000"}), kUsage, {"--size", "8192"});
    for (const char* cosine : {"1.5", "-0.1", "nan"})
        expect_failure(run_lacquer({"albedo", "--material", "gold", "--cos", cosine}), kUsage,
                       {"--cos", cosine});
    EXPECT_THAT(folder.entries(), IsEmpty());
}

TEST(BadUsage, DirectionsThatAreNotUnitAreErrorsAndNotNormalized) {
    const TemporaryFolder folder;
    const std::string output = (folder / "x.exr").string();
    expect_failure(run_lacquer({"slice", "--material", "gold", "-o", output, "--wo", "1,1,1"}),
                   kUsage, {"--wo", "1.73205", "1e-05"});
    expect_failure(run_lacquer({"slice", "--material", "gold", "-o", output, "--wo", "0,0.6,-0.8"}),
                   kUsage, {"--wo", "-0.8", "[0, 1]"});
    expect_failure(run_lacquer({"sphere", "--material", "gold", "-o", output, "--light", "-1,0,1"}),
                   kUsage, {"--light", "1.41421"});
    expect_failure(
        run_lacquer({"sphere", "--material", "gold", "-o", output, "--light", "0,0,nan"}), kUsage,
        {"--light", "nan"});
    expect_failure(run_lacquer({"sphere", "--material", "gold", "-o", output, "--light", "0,1"}),
                   kUsage, {"--light"});
    EXPECT_THAT(folder.entries(), IsEmpty());
}

class BadMaterial : public ::testing::Test {
 protected:
    // Draws a sphere of a material file with this text.
    ProcessResult draw(const std::string& text) {
        write_file(folder_ / "bad.json", text);
        return run_lacquer({"sphere", "--material", (folder_ / "bad.json").string(), "--size", "16",
                            "-o", (folder_ / "x.exr").string()});
    }

    TemporaryFolder folder_;
};

TEST_F(BadMaterial, IsNamedWithPlaceValueAndRange) {
    expect_failure(draw("{"), kFailure, {"bad.json"});
    expect_failure(draw(""), kFailure, {"bad.json"});
    expect_failure(draw(R"({"name": "x", "base": {"lambertian": {"albedo": [1, 1, 2]}}})"),
                   kFailure, {"bad.json", "/base/lambertian/albedo/2", "2", "1"});
    expect_failure(draw(R"({"name": "x", "base": {"lambertian": {"albedo": [1, 1, NaN]}}})"),
                   kFailure, {"bad.json"});
    expect_failure(draw(R"({"name": "x", "base": "none", "shine": 1})"), kFailure,
                   {"bad.json", "shine", "layers"});
    EXPECT_THAT(folder_.entries(), ElementsAre("bad.json"));
}

TEST_F(BadMaterial, ThatIsMissingIsNamed) {
    expect_failure(run_lacquer({"sphere", "--material", (folder_ / "no.json").string(), "-o",
                                (folder_ / "x.exr").string()}),
                   kFailure, {"no.json"});
    EXPECT_THAT(folder_.entries(), IsEmpty());
}

constexpr const char* kTextured =
    R"({"name": "x", "base": {"lambertian": {"albedo": [{"texture": "a.exr"}, 0.5, 0.5]}}})";

TEST_F(BadMaterial, WithAMissingTextureNamesTheTexture) {
    expect_failure(draw(kTextured), kFailure, {"a.exr"});
    EXPECT_THAT(folder_.entries(), ElementsAre("bad.json"));
}

TEST_F(BadMaterial, WithATruncatedTextureNamesTheTexture) {
    Image image{64, 64};
    for (glm::vec4& pixel : image.pixels) pixel = glm::vec4{0.5f};
    const std::string bytes = encode_exr(image, {});
    write_file(folder_ / "a.exr", bytes.substr(0, bytes.size() / 2));
    expect_failure(draw(kTextured), kFailure, {"a.exr"});
    write_file(folder_ / "a.exr", "not a picture");
    expect_failure(draw(kTextured), kFailure, {"a.exr", "EXR"});
    EXPECT_THAT(folder_.entries(), ElementsAre("a.exr", "bad.json"));
}

TEST_F(BadMaterial, WithATextureValueOutOfRangeNamesTextureAndRange) {
    Image image{2, 2};
    for (glm::vec4& pixel : image.pixels) pixel = glm::vec4{1.5f};
    write_file(folder_ / "a.exr", encode_exr(image, {}));
    expect_failure(draw(kTextured), kFailure, {"a.exr", "/base/lambertian/albedo/0", "1.5"});
    EXPECT_THAT(folder_.entries(), ElementsAre("a.exr", "bad.json"));
}

TEST_F(BadMaterial, TexturesOutsidePicturesOfSurfacesAreRefused) {
    write_file(folder_ / "bad.json", kTextured);
    expect_failure(
        run_lacquer({"eval", "--material", (folder_ / "bad.json").string(), "--queries", "-"},
                    kQuery),
        kFailure, {"/base/lambertian/albedo/0", "texture"});
}

TEST(BadOutput, IsNamedBeforeAnythingIsComputed) {
    const TemporaryFolder folder;
    const auto draw = [](const char* command, const std::filesystem::path& output) {
        return run_lacquer({command, "--material", "gold", "-o", output.string()});
    };
    for (const char* command : {"slice", "sphere"}) {
        expect_failure(draw(command, folder / "no/x.exr"), kFailure, {"no/x.exr"});
        expect_failure(draw(command, folder / "x.jpg"), kUsage, {"x.jpg", ".exr, .png"});
        expect_failure(draw(command, folder / "x"), kUsage, {".exr, .png"});
    }
    EXPECT_THAT(folder.entries(), IsEmpty());
}

TEST(BadOutput, AReportCannotReplaceAFile) {
    const TemporaryFolder folder;
    write_file(folder / "taken", "mine");
    expect_failure(run_lacquer({"compare", "--material", "gold", "--backend", "cpp", "--report",
                                (folder / "taken").string()}),
                   kFailure, {"taken"});
    EXPECT_EQ(read_file(folder / "taken"), "mine");
}

TEST(BadOutput, AFullDiskIsAFailure) {
    const ProcessResult result =
        run_process("/bin/sh", {"-c", std::string{"'"} + LACQUER_PROGRAM +
                                          "' albedo --material gold --cos 1 > /dev/full"});
    EXPECT_EQ(result.exit_code, kFailure);
    EXPECT_THAT(result.err, ::testing::HasSubstr("standard output"));
}

TEST(BadOutput, AClosedStandardErrorChangesNoExitCode) {
    const auto exit_code = [](const std::string& arguments) {
        const std::string program = std::string{"'"} + LACQUER_PROGRAM + "' ";
        return run_process("/bin/sh", {"-c", program + arguments + " 2>&-"}).exit_code;
    };
    EXPECT_EQ(exit_code("albedo --material gold --cos 1"), 0);
    EXPECT_EQ(exit_code("albedo --material gold --cos 2"), kUsage);
    EXPECT_EQ(exit_code("albedo"), kUsage);
}

class BadQueries : public ::testing::Test {
 protected:
    ProcessResult evaluate(const std::string& csv) {
        write_file(folder_ / "q.csv", csv);
        return run_lacquer(
            {"eval", "--material", "gold", "--queries", (folder_ / "q.csv").string()});
    }

    TemporaryFolder folder_;
};

TEST_F(BadQueries, AreNamedWithFileLineAndColumn) {
    const std::string header = "wi_x,wi_y,wi_z,wo_x,wo_y,wo_z\n";
    expect_failure(evaluate(header + "0,0,1,0,0,1\n0,0,1,0,up,1\n"), kFailure,
                   {"q.csv:3", "column 5", "wo_y", "up"});
    expect_failure(evaluate("wi_x,wi_y,wi_z,wo_x,wo_z,wo_y\n0,0,1,0,0,1\n"), kFailure,
                   {"q.csv:1", "column 5", "wo_z"});
    expect_failure(evaluate(header + "0,0,1,0,0.1,1\n"), kFailure, {"q.csv:2", "wo", "1e-05"});
    expect_failure(evaluate(""), kFailure, {"q.csv", "wi_x,wi_y,wi_z"});
}

TEST_F(BadQueries, ThatAreMissingAreNamed) {
    expect_failure(run_lacquer({"eval", "--material", "gold", "--queries", "/no/q.csv"}), kFailure,
                   {"/no/q.csv"});
}

TEST_F(BadQueries, OnTheStandardInputAreNamedToo) {
    expect_failure(run_lacquer({"eval", "--material", "gold", "--queries", "-"}, "x\n"), kFailure,
                   {"standard input:1"});
}

TEST(MissingTools, ABackendWithoutItsDriverNamesTheRemedy) {
    ScopedEnvironment environment;
    environment.set("VK_ICD_FILENAMES", "/nowhere/icd.json");
    for (const char* backend : {"vulkan", "hlsl"})
        expect_failure(
            run_lacquer({"eval", "--material", "gold", "--backend", backend, "--queries", "-"},
                        kQuery),
            kFailure, {"VK_ICD_FILENAMES"});
}

TEST(MissingTools, ABackendWithoutNodeNamesTheRemedy) {
    ScopedEnvironment environment;
    environment.set("LACQUER_NODE", "/nowhere/node");
    expect_failure(
        run_lacquer({"eval", "--material", "gold", "--backend", "wgsl-dawn", "--queries", "-"},
                    kQuery),
        kFailure, {"Node.js", "LACQUER_NODE"});
}

TEST(MissingTools, ADeviceThatIsNotThereIsNamed) {
    expect_failure(run_lacquer({"eval", "--material", "gold", "--backend", "vulkan", "--device",
                                "no such device", "--queries", "-"},
                               kQuery),
                   kFailure, {"no such device"});
}

TEST(MissingData, IsNamedWithItsRemedy) {
    ScopedEnvironment environment;
    environment.set("LACQUER_SHARE", "/nowhere");
    expect_failure(run_lacquer({"albedo", "--material", "gold", "--cos", "1"}), kFailure,
                   {"LACQUER_SHARE", "/nowhere"});
}

}  // namespace
}  // namespace lacquer
