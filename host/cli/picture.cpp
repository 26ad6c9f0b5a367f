#include "cli/picture.h"

#include <CLI/CLI.hpp>

#include "core/version.h"

namespace lacquer {

void add_picture_options(CLI::App& command, PictureOptions& options) {
    command.add_option("-o,--output", options.output, "File to write, .exr or .png")->required();
    command.add_option("--size", options.size, "Pixels of either side")
        ->check(CLI::Range(1, kMaxPictureSize))
        ->capture_default_str();
}

Metadata picture_metadata(const ShadingOptions& options, const Shading& shading) {
    return {{"material", shading.material.name},
            {"model", options.model},
            {"backend", options.backend},
            {"device", shading.backend->device()},
            {"version", kVersion}};
}

}  // namespace lacquer
