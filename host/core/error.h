// How failures travel: thrown where they happen, reported once by the command line.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace lacquer {

// Something asked for cannot be done. The message names the file, the place, the value and the
// allowed range, as far as they apply. Ends a command with exit code 1.
class Error : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

// The command line itself is wrong. Ends a command with exit code 2.
class UsageError : public Error {
 public:
    using Error::Error;
};

// This machine lacks something. `reason` says what, `remedy` what to install or set; the message is
// both.
class Unavailable : public Error {
 public:
    Unavailable(std::string reason, std::string remedy)
        : Error{reason + ": " + remedy}, reason_{std::move(reason)}, remedy_{std::move(remedy)} {}

    const std::string& reason() const { return reason_; }
    const std::string& remedy() const { return remedy_; }

 private:
    std::string reason_;
    std::string remedy_;
};

}  // namespace lacquer
