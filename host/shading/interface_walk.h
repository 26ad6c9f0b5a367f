// The shader source's walk through an interface, as C++ in float.
#pragma once

#include <cstdint>
#include <glm/vec4.hpp>

namespace lacquer {

// LqInterfaceSums of shader_src/microsurface/walk.glsl.
struct InterfaceSums {
    glm::vec4 energies, squares, spread;
};

// `boundary` is (alpha, eta, tau, cos_theta), clamped to the ranges of the shader source; `stream`
// a whole number of at most 2^24.
InterfaceSums walk_interface(const glm::vec4& boundary, float stream, std::uint32_t walk_count);

}  // namespace lacquer
