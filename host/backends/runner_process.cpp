#include "backends/runner_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>

#include <array>
#include <boost/process.hpp>
#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "core/error.h"

namespace lacquer {

namespace bp = boost::process;
using nlohmann::json;

namespace {

// Fewer turns of the two processes; the most that Linux grants everyone.
constexpr int kPipeCapacity = 1 << 20;

// No answer announces more text: what claims to is no answer.
constexpr std::uint32_t kMaxAnswerSize = 1 << 24;

// How long a process may take to end once its input has.
constexpr std::chrono::seconds kPatience{2};

// How long an answer may take: compiling may take minutes, and so may starting Wine the first time.
constexpr std::chrono::milliseconds kAnswerPatience = std::chrono::minutes{10};

// How much of what the process wrote to its standard error is quoted.
constexpr long kLastWords = 2000;

// While alive, writing to a pipe that nobody reads fails instead of ending the process.
class IgnoredBrokenPipe {
 public:
    IgnoredBrokenPipe() {
        sigemptyset(&signals_);
        sigaddset(&signals_, SIGPIPE);
        pthread_sigmask(SIG_BLOCK, &signals_, &before_);
    }
    ~IgnoredBrokenPipe() {
        const timespec now{};
        if (sigismember(&before_, SIGPIPE) == 0) sigtimedwait(&signals_, nullptr, &now);
        pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    }
    IgnoredBrokenPipe(const IgnoredBrokenPipe&) = delete;
    IgnoredBrokenPipe& operator=(const IgnoredBrokenPipe&) = delete;

 private:
    sigset_t signals_{}, before_{};
};

// A pipe whose ends other processes do not inherit, or it would not end with ours.
bp::pipe private_pipe() {
    bp::pipe pipe;
    for (const int end : {pipe.native_source(), pipe.native_sink()})
        fcntl(end, F_SETFD, FD_CLOEXEC);
    fcntl(pipe.native_sink(), F_SETPIPE_SZ, kPipeCapacity);
    return pipe;
}

std::string_view kind_name(BufferArgument::Kind kind) {
    switch (kind) {
        case BufferArgument::Kind::uniform:
            return "uniform";
        case BufferArgument::Kind::read:
            return "read";
        case BufferArgument::Kind::write:
            return "write";
    }
    return "";
}

}  // namespace

struct RunnerProcess::Impl {
    std::string program;
    bp::pipe input = private_pipe();   // of the process
    bp::pipe output = private_pipe();  // of the process
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> errors{std::tmpfile(), std::fclose};
    bp::child child;
    std::string adapter;

    explicit Impl(const RunnerProgram& what);
    ~Impl();
    void write(std::span<const std::byte> bytes);
    void read(std::span<std::byte> bytes);
    void request(const json& request, std::span<const BufferArgument> arguments = {});
    json answer();
    [[noreturn]] void throw_last_words();
};

RunnerProcess::Impl::Impl(const RunnerProgram& what) : program{what.program.string()} {
    if (!errors) throw Error{"a temporary file cannot be created"};
    try {
        child = bp::child{bp::exe = program, bp::args = what.arguments,
                          bp::std_in<input, bp::std_out> output, bp::std_err > errors.get()};
    } catch (const bp::process_error& error) {
        throw Error{fmt::format("starting '{}': {}", program, error.code().message())};
    }
    adapter = answer().value("adapter", "");
}

RunnerProcess::Impl::~Impl() {
    std::error_code ignored;  // it may be gone already
    input.close();
    if (!child.wait_for(kPatience, ignored)) child.terminate(ignored);
}

void RunnerProcess::Impl::write(std::span<const std::byte> bytes) {
    const IgnoredBrokenPipe guard;
    while (!bytes.empty()) {
        const ssize_t count = ::write(input.native_sink(), bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) throw_last_words();
        bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
}

void RunnerProcess::Impl::read(std::span<std::byte> bytes) {
    while (!bytes.empty()) {
        pollfd waiting{output.native_source(), POLLIN, 0};
        if (poll(&waiting, 1, static_cast<int>(kAnswerPatience.count())) == 0)
            throw Error{fmt::format("'{}' does not answer", program)};
        const ssize_t count = ::read(output.native_source(), bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) throw_last_words();
        bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
}

void RunnerProcess::Impl::throw_last_words() {
    std::error_code ignored;
    if (!child.wait_for(kPatience, ignored)) child.terminate(ignored);
    std::fseek(errors.get(), 0, SEEK_END);
    const long end = std::ftell(errors.get());
    std::fseek(errors.get(), std::max(0L, end - kLastWords), SEEK_SET);
    std::string words(kLastWords, '\0');
    words.resize(std::fread(words.data(), 1, words.size(), errors.get()));
    throw Error{
        fmt::format("'{}' ended (status {}): {}", program, child.native_exit_code(), words)};
}

void RunnerProcess::Impl::request(const json& request, std::span<const BufferArgument> arguments) {
    const std::string text = request.dump();
    const auto size = static_cast<std::uint32_t>(text.size());
    write(std::as_bytes(std::span{&size, 1}));
    write(std::as_bytes(std::span{text}));
    for (const BufferArgument& argument : arguments) write(argument.bytes);
}

json RunnerProcess::Impl::answer() {
    std::uint32_t size = 0;
    read(std::as_writable_bytes(std::span{&size, 1}));
    if (size > kMaxAnswerSize) throw Error{fmt::format("'{}' wrote no answer", program)};
    std::string text(size, '\0');
    read(std::as_writable_bytes(std::span{text}));
    json answer = json::parse(text, nullptr, /*allow_exceptions=*/false);
    if (!answer.is_object()) throw Error{fmt::format("'{}' wrote no answer", program)};
    if (const auto error = answer.find("error"); error != answer.end())
        throw Error{error->get<std::string>()};
    return answer;
}

RunnerProcess::RunnerProcess(const RunnerProgram& program)
    : impl_{std::make_unique<Impl>(program)} {}
RunnerProcess::~RunnerProcess() = default;

const std::string& RunnerProcess::adapter() const {
    return impl_->adapter;
}

void RunnerProcess::compile(const std::string& kernel, const std::string& source,
                            const std::string& entry_point,
                            std::span<const BufferArgument::Kind> kinds) {
    json names = json::array();
    for (const BufferArgument::Kind kind : kinds) names.push_back(kind_name(kind));
    impl_->request({{"operation", "compile"},
                    {"kernel", kernel},
                    {"source", source},
                    {"entry_point", entry_point},
                    {"kinds", names}});
    impl_->answer();
}

void RunnerProcess::check(const std::string& source, const std::string& entry_point) {
    impl_->request({{"operation", "check"}, {"source", source}, {"entry_point", entry_point}});
    impl_->answer();
}

void RunnerProcess::run(const std::string& kernel, std::span<const BufferArgument> arguments,
                        std::uint32_t groups) {
    json buffers = json::array();
    for (const BufferArgument& argument : arguments)
        buffers.push_back({{"kind", kind_name(argument.kind)}, {"size", argument.size()}});
    impl_->request(
        {{"operation", "run"}, {"kernel", kernel}, {"groups", groups}, {"buffers", buffers}},
        arguments);
    impl_->answer();
    for (const BufferArgument& argument : arguments) impl_->read(argument.results);
}

}  // namespace lacquer
