// HLSL through glslang's front end.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace lacquer {

// Compiles a compute shader of shader model 5.0; register N of any kind becomes binding N of set 0.
// `file` stands for it in messages. Throws Error with glslang's message.
std::vector<std::uint32_t> hlsl_to_spirv(const std::string& source, const std::string& entry_point,
                                         const std::string& file);

}  // namespace lacquer
