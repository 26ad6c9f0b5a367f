// Pictures in files, the format chosen by the file's extension: .exr or .png.
#pragma once

#include <filesystem>

#include "image/exr.h"
#include "image/image.h"

namespace lacquer {

// Throws UsageError for an extension that is neither .exr nor .png, and Error where `file` cannot
// be written: what a command checks before it computes.
void require_image_output(const std::filesystem::path& file);

// Whether `file` holds what a display shows (.png), not linear numbers.
bool is_display_format(const std::filesystem::path& file);

// Writes linear floats with `metadata` (.exr), or what a display shows (.png; see display.h). The
// file appears whole or not at all.
void write_image(const std::filesystem::path& file, const Image& image, const Metadata& metadata);

// Reads a picture's numbers as they stand in the file: floats (.exr), or levels / 255 (.png).
// Throws Error naming the file where it is missing, damaged or of another format.
Image read_image(const std::filesystem::path& file);

}  // namespace lacquer
