#include "core/process.h"

#include <fmt/format.h>

#include <boost/asio/io_context.hpp>
#include <boost/process.hpp>
#include <future>

#include "core/error.h"

namespace lacquer {

namespace bp = boost::process;

ProcessResult run_process(const std::filesystem::path& program,
                          const std::vector<std::string>& arguments, const std::string& input) {
    try {
        boost::asio::io_context context;
        std::future<std::string> out;
        std::future<std::string> err;
        bp::child child{bp::exe = program.string(), bp::args = arguments,
                        bp::std_in<boost::asio::buffer(input), bp::std_out> out, bp::std_err > err,
                        context};
        context.run();
        child.wait();
        return {child.exit_code(), out.get(), err.get()};
    } catch (const bp::process_error& error) {
        throw Error{fmt::format("starting '{}': {}", program.string(), error.code().message())};
    }
}

std::optional<std::filesystem::path> find_program(const std::string& name) {
    const auto found = bp::search_path(name);
    if (found.empty()) return std::nullopt;
    return found.string();
}

std::optional<std::filesystem::path> find_wine() {
    constexpr const char* kDebianWine = "/usr/lib/wine/wine64";
    for (const char* name : {"wine64", "wine"})
        if (auto found = find_program(name)) return found;
    if (std::filesystem::exists(kDebianWine)) return kDebianWine;
    return std::nullopt;
}

}  // namespace lacquer
