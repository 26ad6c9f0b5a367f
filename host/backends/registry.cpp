#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

#include "backends/backend.h"
#include "backends/entries.h"
#include "core/error.h"

namespace lacquer {

std::span<const BackendEntry> all_backends() {
    static const std::array entries{kReferenceEntry, kCppEntry,    kVulkanEntry, kGlslEntry,
                                    kEsslEntry,      kHlslEntry,   kWgpuEntry,   kDawnEntry,
                                    kMslEntry,       kHlslFxcEntry};
    return entries;
}

const BackendEntry& backend_from_name(std::string_view name) {
    std::vector<std::string_view> known;
    for (const BackendEntry& entry : all_backends()) {
        if (entry.name == name) return entry;
        known.push_back(entry.name);
    }
    throw UsageError{fmt::format("backend '{}' is not one of: {}", name, fmt::join(known, ", "))};
}

Availability probe_by_trying(const std::function<std::string()>& attempt) {
    try {
        return {true, attempt(), ""};
    } catch (const Unavailable& missing) {
        return {false, missing.reason(), missing.remedy()};
    } catch (const Error& error) {
        return {false, error.what(), ""};
    }
}

}  // namespace lacquer
