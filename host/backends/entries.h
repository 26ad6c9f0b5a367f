// The entries of the registry, each defined beside its backend.
#pragma once

#include <functional>

#include "backends/backend.h"

namespace lacquer {

extern const BackendEntry kReferenceEntry;
extern const BackendEntry kCppEntry;
extern const BackendEntry kVulkanEntry;
extern const BackendEntry kGlslEntry;
extern const BackendEntry kEsslEntry;
extern const BackendEntry kHlslEntry;
extern const BackendEntry kWgpuEntry;
extern const BackendEntry kDawnEntry;
extern const BackendEntry kMslEntry;
extern const BackendEntry kHlslFxcEntry;

// Whether `attempt` succeeds, which returns the device or throws what this machine lacks. Trying is
// the only test that tells the truth about drivers.
Availability probe_by_trying(const std::function<std::string()>& attempt);

}  // namespace lacquer
