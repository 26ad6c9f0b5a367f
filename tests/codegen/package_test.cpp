// What a package lists, and how it gets to disk.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cctype>
#include <ctime>
#include <nlohmann/json.hpp>
#include <set>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "check.h"
#include "codegen/sha256.h"
#include "codegen/variants.h"
#include "core/file.h"
#include "support/temporary_folder.h"

namespace lacquer::test {
namespace {

using codegen::Form;
using codegen::Package;
using codegen::ShaderFile;
using codegen::Target;
using nlohmann::json;

// Generating everything must not slow a build down. Of the processor's time: 45 seconds, most of
// it spirv-opt's, which counts the instructions of every function of eleven levels, stacks' above all; half as
// much again is for neighbours that share its caches.
constexpr double kMaxSeconds = 67.5;

bool fits_schema(const json& document) {
    using Adapter = valijson::adapters::NlohmannJsonAdapter;
    const json text = json::parse(read_file(MANIFEST_SCHEMA));
    valijson::Schema schema;
    valijson::SchemaParser parser;
    parser.populateSchema(Adapter{text}, schema);
    valijson::Validator validator;
    return validator.validate(schema, Adapter{document}, nullptr);
}

json manifest_of(const Package& package) {
    return json::parse(codegen::manifest(package));
}

const ShaderFile& find_file(const std::string& path) {
    for (const ShaderFile& file : everything().files)
        if (file.path == path) return file;
    throw std::runtime_error{"no file " + path};
}

TEST(Package, IsGeneratedInSeconds) {
    const std::clock_t start = std::clock();
    codegen::Request request;
    request.source_root = SHADER_SOURCE;
    const Package package = codegen::generate(request);
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    fmt::print("{} files in {:.2f} s\n", package.files.size(), seconds);
    EXPECT_LT(seconds, kMaxSeconds);
}

TEST(Package, IsTheSameEveryTime) {
    codegen::Request request;
    request.source_root = SHADER_SOURCE;
    request.tables_folder = BAKED_TABLES;
    const Package again = codegen::generate(request);
    ASSERT_EQ(again.files.size(), everything().files.size());
    for (std::size_t i = 0; i < again.files.size(); ++i)
        EXPECT_TRUE(again.files[i].contents == everything().files[i].contents)
            << again.files[i].path;
    EXPECT_EQ(codegen::manifest(again), codegen::manifest(everything()));
}

TEST(Package, IsTheSameFromAnyFolder) {
    const TemporaryFolder folder;
    std::filesystem::copy(SHADER_SOURCE, folder / "elsewhere",
                          std::filesystem::copy_options::recursive);
    codegen::Request request;
    request.source_root = folder / "elsewhere";
    request.targets = {Target::spirv, Target::glsl450};
    for (const ShaderFile& file : codegen::generate(request).files)
        EXPECT_TRUE(file.contents == find_file(file.path.string()).contents) << file.path;
}

TEST(Package, HoldsEveryKernelAndLevelInEveryLanguageThatCanExpressIt) {
    std::set<std::string> paths;
    for (const ShaderFile& file : everything().files) paths.insert(file.path.string());
    EXPECT_EQ(paths.size(), everything().files.size());
    const codegen::SourceTree tree{SHADER_SOURCE};
    for (const char* target : {"glsl450", "essl310", "hlsl50", "hlsl60", "msl", "wgsl", "spirv"}) {
        for (const codegen::KernelSource& source : codegen::all_kernels(tree)) {
            const auto holds = [&](const std::string& path) {
                return path.starts_with(fmt::format("{}/kernel/plain_{}.", target, source.kernel));
            };
            EXPECT_TRUE(std::ranges::any_of(paths, holds)) << target << " " << source.kernel;
        }
    }
    for (const char* library :
         {"glsl450/library/plain.glsl", "essl310/library/plain.glsl", "essl300/library/plain.glsl",
          "hlsl50/library/plain.hlsl", "hlsl60/library/plain.hlsl", "msl/library/plain.metal",
          "wgsl/library/plain.wgsl"})
        EXPECT_TRUE(paths.contains(library)) << library;
}

TEST(Package, KernelsBindWhatTheHostBinds) {
    for (const Target target : {Target::spirv, Target::hlsl50, Target::msl, Target::wgsl}) {
        for (const ShaderFile& file : files_of(target, Form::kernel)) {
            if (file.kernel != "eval") continue;
            const char* names[] = {"parameters", "surfaces", "inputs", "results", "tables"};
            const char* kinds[] = {"uniform", "storage_read", "storage_read", "storage_read_write",
                                   "storage_read"};
            const unsigned count = codegen::level_from_name(file.level).reads_tables ? 5 : 4;
            ASSERT_EQ(file.bindings.size(), count);
            for (unsigned i = 0; i < count; ++i) {
                EXPECT_EQ(file.bindings[i].name, names[i]);
                EXPECT_EQ(file.bindings[i].kind, kinds[i]);
                EXPECT_EQ(file.bindings[i].set, 0u);
                EXPECT_EQ(file.bindings[i].binding, i);
            }
            ASSERT_EQ(file.entry_points.size(), 1u);
            EXPECT_THAT(file.entry_points[0].workgroup_size, testing::ElementsAre(64, 1, 1));
        }
    }
}

TEST(Package, EntryPointsStandInTheirFiles) {
    for (const ShaderFile& file : everything().files)
        for (const codegen::EntryPoint& point : file.entry_points)
            EXPECT_THAT(file.contents, testing::HasSubstr(point.name)) << file.path;
}

std::string without_space(std::string text) {
    std::erase_if(text, [](unsigned char c) { return std::isspace(c) != 0; });
    return text;
}

TEST(Package, FunctionsStandInTheirFilesAsListed) {
    for (const Target target : text_targets()) {
        for (const ShaderFile& file : files_of(target, Form::library)) {
            EXPECT_GT(file.functions.size(), 20u);
            const std::string contents = without_space(file.contents);
            for (const codegen::Function& function : file.functions) {
                EXPECT_THAT(function.signature, testing::HasSubstr(function.name + "("));
                // A long signature stands on several lines.
                EXPECT_THAT(contents, testing::HasSubstr(without_space(function.signature.substr(
                                          0, function.signature.find(',')))));
            }
        }
    }
}

TEST(Package, SummariesAreFirstSentences) {
    const ShaderFile& file = find_file("glsl450/library/plain.glsl");
    const auto summary_of = [&](const std::string& name) {
        for (const codegen::Function& function : file.functions)
            if (function.name == name) return function.summary;
        return std::string{"(absent)"};
    };
    EXPECT_EQ(summary_of("lq_plain_eval_cos"), "f(wi, wo) cos_theta_i.");
    EXPECT_EQ(summary_of("lq_reflection_lobe"),
              "D G2 / (4 cos_theta_i cos_theta_o), per solid angle, for wi and wo above the "
              "surface.");
}

// FIPS 180-4, and the empty text.
TEST(Package, HashesAreSha256) {
    EXPECT_EQ(codegen::sha256("abc"),
              "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(codegen::sha256(""),
              "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(Package, ManifestFitsItsSchema) {
    EXPECT_TRUE(fits_schema(manifest_of(everything())));
}

TEST(Package, ManifestNamesWhatWasChosen) {
    EXPECT_EQ(manifest_of(everything()).at("stacks"), (json{{"max_layers", 8}, {"lobes", 3}}));
    Package package;
    package.source_sha256 = everything().source_sha256;
    for (const int layers : {codegen::kMinLayers, codegen::kMaxLayers}) {
        package.stacks = {layers, 2};
        const json manifest = manifest_of(package);
        EXPECT_EQ(manifest.at("stacks"), (json{{"max_layers", layers}, {"lobes", 2}}));
        EXPECT_TRUE(fits_schema(manifest));
    }
}

TEST(Package, SchemaRefusesOtherDocuments) {
    const json good = manifest_of(everything());
    const auto refuses = [&](const auto& change) {
        json changed = good;
        change(changed);
        return !fits_schema(changed);
    };
    EXPECT_TRUE(refuses([](json& m) { m.erase("version"); }));
    EXPECT_TRUE(refuses([](json& m) { m.erase("stacks"); }));
    EXPECT_TRUE(refuses([](json& m) { m["stacks"]["lobes"] = 4; }));
    EXPECT_TRUE(refuses([](json& m) { m["stacks"]["max_layers"] = codegen::kMaxLayers + 1; }));
    EXPECT_TRUE(refuses([](json& m) { m["files"][0]["sha256"] = "0"; }));
    EXPECT_TRUE(refuses([](json& m) { m["files"][0]["target"] = "cg"; }));
    EXPECT_TRUE(refuses([](json& m) { m["files"][0]["bytes"] = -1; }));
    EXPECT_TRUE(refuses([](json& m) { m["files"][0]["more"] = 1; }));
    EXPECT_TRUE(refuses([](json& m) { m["tables"][0].erase("width"); }));
    EXPECT_TRUE(refuses([](json& m) { m["tables"][0]["format"] = "rgba8"; }));
    EXPECT_TRUE(refuses([](json& m) { m["files"][0]["entry_points"][0]["stage"] = "mesh"; }));
}

TEST(Package, WrittenFilesAreWhatTheManifestSays) {
    const TemporaryFolder folder;
    codegen::write(everything(), folder / "shaders");
    const json manifest = json::parse(read_file(folder / "shaders" / "manifest.json"));
    std::size_t files = 1;
    for (const char* list : {"files", "tables"})
        for (const json& entry : manifest.at(list)) {
            const std::string bytes =
                read_file(folder / "shaders" / entry.at("path").get<std::string>());
            EXPECT_EQ(bytes.size(), entry.at("bytes"));
            EXPECT_EQ(codegen::sha256(bytes), entry.at("sha256"));
            ++files;
        }
    std::size_t found = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator{folder / "shaders"})
        found += entry.is_regular_file() ? 1 : 0;
    EXPECT_EQ(found, files);
    EXPECT_EQ(manifest.at("source_sha256"), codegen::SourceTree{SHADER_SOURCE}.hash());
}

TEST(Package, SourceHashFollowsEveryFile) {
    const TemporaryFolder folder;
    std::filesystem::copy(SHADER_SOURCE, folder / "changed",
                          std::filesystem::copy_options::recursive);
    const std::filesystem::path file = folder / "changed" / "core" / "random.glsl";
    write_file(file, read_file(file) + "// more\n");
    EXPECT_NE(codegen::SourceTree{folder / "changed"}.hash(),
              codegen::SourceTree{SHADER_SOURCE}.hash());
}

}  // namespace
}  // namespace lacquer::test
