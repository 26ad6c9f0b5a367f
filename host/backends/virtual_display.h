// An X display that nobody sees, for programs that insist on one.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

namespace lacquer {

// Runs Xvfb while it lives.
class VirtualDisplay {
 public:
    // Throws Unavailable where Xvfb is missing, Error where it does not start.
    VirtualDisplay();
    ~VirtualDisplay();
    VirtualDisplay(const VirtualDisplay&) = delete;
    VirtualDisplay& operator=(const VirtualDisplay&) = delete;

    // The value of DISPLAY for its programs: ":97".
    const std::string& name() const;

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// Throws Unavailable where Xvfb is missing.
std::filesystem::path require_xvfb();

}  // namespace lacquer
