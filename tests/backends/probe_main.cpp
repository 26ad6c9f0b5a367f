// Prints what every backend says about itself: NAME, "usable" or "missing", detail, remedy, with
// tabs between. A program of its own so that tests can start it in environments that lack things.
#include <fmt/format.h>

#include "backends/backend.h"

int main() {
    for (const lacquer::BackendEntry& entry : lacquer::all_backends()) {
        const lacquer::Availability found = entry.probe({});
        fmt::print("{}\t{}\t{}\t{}\n", entry.name, found.usable ? "usable" : "missing",
                   found.detail, found.remedy);
    }
}
