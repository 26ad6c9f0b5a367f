#include "report/junit.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "markup/markup.h"

namespace lacquer {

namespace {

std::string case_text(const BackendResult& backend, const std::string& material, double seconds,
                      const std::string& outcome) {
    return fmt::format(
        R"(    <testcase classname="lacquer.compare.{}" name="{}" time="{:.6f}">{}</testcase>)"
        "\n",
        escaped(backend.name), escaped(material), seconds, outcome);
}

std::string measured_cases(const BackendResult& backend) {
    std::string cases;
    for (const MaterialResult& material : backend.materials) {
        const std::string outcome = material.passed
                                        ? std::string{}
                                        : fmt::format(R"(<failure message="{}">{}</failure>)",
                                                      escaped(failure_line(backend, material)),
                                                      escaped(replay_command(backend, material)));
        const double seconds = backend.seconds / double(backend.materials.size());
        cases += case_text(backend, material.name, seconds, outcome);
    }
    return cases;
}

std::string unmeasured_cases(const CompareResult& result, const BackendResult& backend) {
    const char* element = backend.status == Status::skipped ? "skipped" : "error";
    const std::string outcome =
        fmt::format(R"(<{} message="{}"/>)", element, escaped(backend.reason));
    std::string cases;
    for (const NamedMaterial& material : result.materials)
        cases += case_text(backend, material.name, 0.0, outcome);
    return cases;
}

std::string suite_text(const CompareResult& result, const BackendResult& backend) {
    const bool measured = !backend.materials.empty();
    const std::size_t count = result.materials.size();
    const auto failed = std::count_if(backend.materials.begin(), backend.materials.end(),
                                      [](const MaterialResult& m) { return !m.passed; });
    return fmt::format(
        R"(  <testsuite name="{}" tests="{}" failures="{}" errors="{}" skipped="{}" time="{:.6f}">)"
        "\n{}  </testsuite>\n",
        escaped(backend.name), count, failed,
        !measured && backend.status == Status::failed ? count : 0,
        backend.status == Status::skipped ? count : 0, backend.seconds,
        measured ? measured_cases(backend) : unmeasured_cases(result, backend));
}

}  // namespace

std::string compare_junit(const CompareResult& result) {
    std::string suites;
    for (const BackendResult& backend : result.backends) suites += suite_text(result, backend);
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"lacquer "
        "compare\">\n{}</testsuites>\n",
        suites);
}

}  // namespace lacquer
