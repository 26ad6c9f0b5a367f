#include "core/file.h"

#include <gmock/gmock.h>

#include <functional>

#include "core/error.h"
#include "support/temporary_folder.h"

namespace lacquer {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string message_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

TEST(File, ReturnsTheBytesThatWereWritten) {
    const TemporaryFolder folder;
    const std::string bytes{"a\0b\r\n\xff", 6};
    write_file(folder / "x", bytes);
    EXPECT_EQ(read_file(folder / "x"), bytes);
    EXPECT_THAT(folder.entries(), ElementsAre("x"));
}

TEST(File, ReplacesWhatWasThere) {
    const TemporaryFolder folder;
    write_file(folder / "x", "something longer");
    write_file(folder / "x", "new");
    EXPECT_EQ(read_file(folder / "x"), "new");
}

TEST(File, ReadingAMissingFileNamesItAndTheReason) {
    const std::string message = message_of([] { read_file("/nowhere/x"); });
    EXPECT_THAT(message, HasSubstr("/nowhere/x"));
    EXPECT_THAT(message, HasSubstr("No such file"));
}

TEST(File, ReadingAFolderIsAnError) {
    const TemporaryFolder folder;
    EXPECT_THAT(message_of([&] { read_file(folder.path()); }), HasSubstr("directory"));
}

TEST(File, WritingIntoAMissingFolderIsAnErrorBeforeAndDuring) {
    const TemporaryFolder folder;
    const fs::path file = folder / "missing" / "x";
    EXPECT_THAT(message_of([&] { require_writable(file); }), HasSubstr(file.string()));
    EXPECT_THAT(message_of([&] { write_file(file, "x"); }), HasSubstr(file.string()));
    EXPECT_THAT(folder.entries(), IsEmpty());
}

TEST(File, WritingOverAFolderLeavesNothingBehind) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "x");
    EXPECT_THROW(require_writable(folder / "x"), Error);
    EXPECT_THROW(write_file(folder / "x", "x"), Error);
    EXPECT_THAT(folder.entries(), ElementsAre("x"));
}

TEST(File, WritesThroughALink) {
    const TemporaryFolder folder;
    write_file(folder / "target", "old");
    fs::create_symlink(folder / "target", folder / "link");
    write_file(folder / "link", "new");
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(read_file(folder / "target"), "new");
}

TEST(File, WritesToADeviceWithoutReplacingIt) {
    write_file("/dev/null", "x");
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(File, AFullDeviceIsAnError) {
    EXPECT_THAT(message_of([] { write_file("/dev/full", std::string(1 << 20, 'x')); }),
                HasSubstr("/dev/full"));
}

}  // namespace
}  // namespace lacquer
