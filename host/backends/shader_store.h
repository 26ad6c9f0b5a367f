// The generated kernels that the program ships with.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "backends/kernel.h"
#include "core/model.h"

namespace lacquer {

struct ShaderSource {
    std::filesystem::path file;
    std::string contents;  // text, or the words of SPIR-V as bytes
    std::string entry_point;
};

// The level of the shader source whose generated files the kernel stands among.
std::string_view kernel_level(Model model, Kernel kernel);

// Reads the kernel in the language `target`, named as in the manifest ("spirv", "wgsl", ...).
// Throws Error where the manifest or the file is missing or broken, or the kernel was not
// generated.
ShaderSource load_shader(std::string_view target, Model model, Kernel kernel);

}  // namespace lacquer
