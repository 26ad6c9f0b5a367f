// What goes wrong is said with its place, and leaves nothing behind.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include "check.h"
#include "core/environment.h"
#include "core/error.h"
#include "core/file.h"
#include "support/temporary_folder.h"

namespace lacquer::test {
namespace {

using codegen::Target;
using testing::AllOf;
using testing::HasSubstr;

// A copy of the shader source that a test may spoil.
class SpoiledSource {
 public:
    SpoiledSource() {
        std::filesystem::copy(SHADER_SOURCE, root(), std::filesystem::copy_options::recursive);
    }

    std::filesystem::path root() const { return folder_ / "source"; }

    // Puts `line` at the end of a file; returns its number.
    int append(const std::string& file, const std::string& line) {
        const std::string text = read_file(root() / file);
        write_file(root() / file, text + line + "\n");
        return static_cast<int>(std::ranges::count(text, '\n')) + 1;
    }

    std::string message() const {
        codegen::Request request;
        request.source_root = root();
        request.targets = {Target::glsl450};
        try {
            codegen::generate(request);
        } catch (const Error& error) {
            return error.what();
        }
        return {};
    }

 private:
    TemporaryFolder folder_;
};

TEST(Errors, SourceThatDoesNotCompileIsNamedWithItsLine) {
    SpoiledSource source;
    const int line = source.append("kernels/eval.comp", "float wrong() { return undeclared; }");
    EXPECT_THAT(source.message(),
                AllOf(HasSubstr("kernels/eval.comp:" + std::to_string(line) + ":"),
                      HasSubstr("undeclared")));
}

TEST(Errors, SourceThatIsIncludedIsNamedWithItsLine) {
    SpoiledSource source;
    // Past the include guard, where every file that includes this one sees it.
    const int line = source.append("core/math.glsl", "float wrong() { return undeclared; }");
    EXPECT_THAT(source.message(), HasSubstr("core/math.glsl:" + std::to_string(line) + ":"));
}

TEST(Errors, MissingIncludeIsNamedWithItsLine) {
    SpoiledSource source;
    const int line = source.append("core/math.glsl", "#include \"absent.glsl\"");
    EXPECT_THAT(source.message(), AllOf(HasSubstr("core/math.glsl:" + std::to_string(line) + ":"),
                                        HasSubstr("absent.glsl")));
}

TEST(Errors, MissingSourceFolderIsNamed) {
    codegen::Request request;
    request.source_root = "/nowhere/shader_src";
    EXPECT_THROW(codegen::generate(request), Error);
}

TEST(Errors, FolderWithoutShadersIsRefused) {
    const TemporaryFolder folder;
    codegen::Request request;
    request.source_root = folder.path();
    EXPECT_THROW(codegen::generate(request), Error);
}

TEST(Errors, UnknownNamesListWhatThereIs) {
    const auto message_of = [](const auto& call) {
        try {
            call();
        } catch (const UsageError& error) {
            return std::string{error.what()};
        }
        return std::string{};
    };
    EXPECT_THAT(message_of([] { codegen::target_from_name("cg"); }),
                AllOf(HasSubstr("'cg'"), HasSubstr("hlsl60"), HasSubstr("wgsl")));
    EXPECT_THAT(message_of([] { codegen::form_from_name("all"); }), HasSubstr("library"));
    EXPECT_THAT(message_of([] {
                    codegen::Request request;
                    request.source_root = SHADER_SOURCE;
                    request.targets = {Target::glsl450};
                    request.levels = {"glossy"};
                    codegen::generate(request);
                }),
                AllOf(HasSubstr("'glossy'"), HasSubstr("plain")));
}

TEST(Errors, AskingForNothingIsAnError) {
    codegen::Request request;
    request.source_root = SHADER_SOURCE;
    request.targets = {Target::spirv};
    request.forms = {codegen::Form::library};
    EXPECT_THROW(codegen::generate(request), UsageError);
}

TEST(Errors, WgslWithoutNagaSaysWhatToInstall) {
    const TemporaryFolder folder;
    ScopedEnvironment environment;
    environment.set("LACQUER_SHARE", folder.path().string());
    codegen::Request request;
    request.source_root = SHADER_SOURCE;
    request.targets = {Target::wgsl};
    EXPECT_FALSE(codegen::wgsl_availability().usable);
    try {
        codegen::generate(request);
        FAIL() << "wrote WGSL without naga";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), AllOf(HasSubstr("naga-wasm"), HasSubstr("npm ci")));
    }
    request.targets = {Target::glsl450};
    EXPECT_NO_THROW(codegen::generate(request));
}

TEST(Errors, AFileInTheWayOfTheFolderIsNamedAndKept) {
    const TemporaryFolder folder;
    write_file(folder / "shaders", "mine");
    EXPECT_THROW(codegen::write(everything(), folder / "shaders"), Error);
    EXPECT_EQ(read_file(folder / "shaders"), "mine");
    EXPECT_THAT(folder.entries(), testing::ElementsAre("shaders"));
}

TEST(Errors, AFailedWriteLeavesWhatWasThere) {
    const TemporaryFolder folder;
    const std::filesystem::path shaders = folder / "shaders";
    codegen::write(everything(), shaders);
    const std::string before = read_file(shaders / "manifest.json");
    // A file where a folder of the package must go.
    std::filesystem::remove_all(shaders / "msl");
    write_file(shaders / "msl", "in the way");
    codegen::Package package = everything();
    for (codegen::ShaderFile& file : package.files) file.contents += "changed";
    EXPECT_THROW(codegen::write(package, shaders), Error);
    EXPECT_EQ(read_file(shaders / "manifest.json"), before);
    EXPECT_FALSE(std::filesystem::exists(shaders / ".lacquer-unfinished"));
}

}  // namespace
}  // namespace lacquer::test
