// Runs the built program as a user would.
#pragma once

#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "core/process.h"

namespace lacquer::test {

using Words = std::vector<std::string>;

// Runs `lacquer` with these arguments and standard input.
ProcessResult run_lacquer(const Words& arguments, const std::string& input = {});

// That the program ended with this code, printed no data, and named each of `parts` in one message
// on stderr that begins with "lacquer: ".
void expect_failure(const ProcessResult& result, int exit_code, const Words& parts);

// That the program ended well. Shows its message where it did not.
void expect_success(const ProcessResult& result);

inline constexpr int kFailure = 1;
inline constexpr int kUsage = 2;

// A material whose BSDF is known in closed form: albedo (0.5, 0.25, 1) over pi, and density
// cos_theta_i / pi.
inline constexpr const char* kLambertian =
    R"({"name": "matte", "base": {"lambertian": {"albedo": [0.5, 0.25, 1.0]}}})";

}  // namespace lacquer::test
