// What the commands that draw pictures share.
#pragma once

#include <filesystem>

#include "cli/options.h"
#include "image/exr.h"

namespace lacquer {

// -o and --size.
struct PictureOptions {
    std::filesystem::path output;
    int size = 512;  // pixels of either side
};

void add_picture_options(CLI::App& command, PictureOptions& options);

// What an EXR says about how it was made.
Metadata picture_metadata(const ShadingOptions& options, const Shading& shading);

inline constexpr int kMaxPictureSize = 8192;

}  // namespace lacquer
