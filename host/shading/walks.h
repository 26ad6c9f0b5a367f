// The walks of the shader source's kernels, as C++ in float: one query each, from its input rows to
// its result rows, whose layout the kernels in shader_src/kernels define.
#pragma once

#include <cstdint>
#include <glm/vec4.hpp>

namespace lacquer {

// Inputs of all are clamped to the ranges of the shader source; streams, seeds and walks are whole
// numbers below 2^24.
void walk_interface(const glm::vec4* inputs, std::uint32_t walk_count, glm::dvec4* results);
void walk_orders(const glm::vec4* inputs, std::uint32_t walk_count, glm::dvec4* results);
void walk_conductors(const glm::vec4* inputs, std::uint32_t walk_count, glm::dvec4* results);
void walk_mirror_lobe(const glm::vec4* inputs, std::uint32_t walk_count, glm::dvec4* results);

// As many walks as the kernel has, whatever `walk_count`.
void walk_exits(const glm::vec4* inputs, std::uint32_t walk_count, glm::dvec4* results);

}  // namespace lacquer
