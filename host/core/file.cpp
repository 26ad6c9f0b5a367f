#include "core/file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>

#include "core/error.h"

namespace lacquer {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(std::string_view doing, const fs::path& file, int code) {
    throw Error{
        fmt::format("{} '{}': {}", doing, file.string(), std::generic_category().message(code))};
}

// What a rename must not replace: devices, pipes, sockets.
bool is_special(const fs::path& file) {
    std::error_code none;
    return fs::exists(file, none) && !fs::is_regular_file(file, none) &&
           !fs::is_directory(file, none);
}

// The file itself where `file` is a link to it, so that the link stays.
fs::path resolved(const fs::path& file) {
    std::error_code none;
    return fs::is_symlink(file, none) ? fs::weakly_canonical(file) : file;
}

void write_directly(const fs::path& file, std::string_view contents, const fs::path& shown) {
    errno = 0;
    std::ofstream stream{file, std::ios::binary};
    stream.write(contents.data(), static_cast<std::streamsize>(contents.size()));
    stream.close();
    if (!stream) fail("writing", shown, errno != 0 ? errno : EIO);
}

fs::path partial_path(const fs::path& file) {
    fs::path partial = file;
    partial += fmt::format(".partial-{}", ::getpid());
    return partial;
}

}  // namespace

std::string read_file(const fs::path& file) {
    if (fs::is_directory(file)) fail("reading", file, EISDIR);
    errno = 0;
    std::ifstream stream{file, std::ios::binary};
    if (!stream) fail("reading", file, errno != 0 ? errno : EIO);
    std::string contents{std::istreambuf_iterator<char>{stream}, {}};
    if (stream.bad()) fail("reading", file, errno != 0 ? errno : EIO);
    return contents;
}

void write_file(const fs::path& file, std::string_view contents) {
    const fs::path target = resolved(file);
    if (is_special(target)) return write_directly(target, contents, file);
    const fs::path partial = partial_path(target);
    std::error_code failure;
    try {
        write_directly(partial, contents, file);
    } catch (const Error&) {
        fs::remove(partial, failure);
        throw;
    }
    fs::rename(partial, target, failure);
    if (!failure) return;
    std::error_code ignored;
    fs::remove(partial, ignored);
    fail("writing", file, failure.value());
}

void require_writable(const fs::path& file) {
    const fs::path target = resolved(file);
    if (fs::is_directory(target)) fail("writing", file, EISDIR);
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path{"."};
    const fs::path& checked = is_special(target) ? target : folder;
    if (checked == folder && !fs::is_directory(folder)) fail("writing", file, ENOENT);
    if (::access(checked.c_str(), W_OK) != 0) fail("writing", file, errno);
}

}  // namespace lacquer
