// Generates every shader at build time: lacquer-codegen SHADER_SRC TABLES OUTPUT. Without Node.js
// it leaves WGSL out and says so.
#include <fmt/format.h>

#include <cstdio>

#include "codegen/codegen.h"
#include "core/error.h"

namespace {

using namespace lacquer;

void run(const char* source_root, const char* tables_folder, const char* output) {
    codegen::Request request;
    request.source_root = source_root;
    request.tables_folder = tables_folder;
    if (const codegen::WgslAvailability wgsl = codegen::wgsl_availability(); !wgsl.usable) {
        fmt::print(stderr, "lacquer-codegen: no WGSL: {}\n", wgsl.reason);
        for (const codegen::Target target : codegen::all_targets())
            if (target != codegen::Target::wgsl) request.targets.push_back(target);
    }
    codegen::write(codegen::generate(request), output);
}

}  // namespace

int main(int argument_count, char** arguments) {
    if (argument_count != 4) {
        fmt::print(stderr, "usage: lacquer-codegen SHADER_SRC TABLES OUTPUT\n");
        return 2;
    }
    try {
        run(arguments[1], arguments[2], arguments[3]);
        return 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
}
