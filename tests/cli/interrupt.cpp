#include "cli/interrupt.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <string_view>
#include <thread>

#include "core/file.h"
#include "support/temporary_folder.h"

namespace lacquer::test {

namespace {

// Whether a process has set a handler for Ctrl-C, as the kernel's mask of caught signals says. Also
// true of one that has ended.
bool catches_interrupts(pid_t process) {
    std::ifstream status{fmt::format("/proc/{}/status", process)};
    constexpr std::string_view kMask = "SigCgt:";
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with("State:") && line.find('Z') != std::string::npos) return true;
        if (line.starts_with(kMask))
            return (std::stoull(line.substr(kMask.size()), nullptr, 16) >> (SIGINT - 1) & 1) != 0;
    }
    return true;
}

bool send_to_file(int stream, const std::string& file) {
    return ::dup2(::open(file.c_str(), O_WRONLY | O_CREAT, 0600), stream) == stream;
}

// Never returns.
void execute(const Words& arguments, const std::string& out, const std::string& err) {
    if (!send_to_file(STDOUT_FILENO, out) || !send_to_file(STDERR_FILENO, err)) ::_exit(126);
    std::vector<char*> words{const_cast<char*>(LACQUER_PROGRAM)};
    for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    ::execv(LACQUER_PROGRAM, words.data());
    ::_exit(127);
}

}  // namespace

ProcessResult interrupt_lacquer(const Words& arguments) {
    const TemporaryFolder folder;
    const std::string out = folder / "out";
    const std::string err = folder / "err";
    const pid_t child = ::fork();
    if (child == 0) execute(arguments, out, err);
    while (!catches_interrupts(child)) std::this_thread::sleep_for(std::chrono::milliseconds{10});
    ::kill(child, SIGINT);
    int status = 0;
    ::waitpid(child, &status, 0);
    ProcessResult result;
    result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    result.out = read_file(out);
    result.err = read_file(err);
    return result;
}

}  // namespace lacquer::test
