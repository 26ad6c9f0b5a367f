// Uniform numbers as a pure function of a counter, the same in every language: a model that asks
// for random numbers draws those of its shaders. Based on: Jarzynski and Olano 2020, Hash Functions
// for GPU Rendering (pcg4d)
#pragma once

#include <array>
#include <cstdint>

namespace lacquer::reference {

// Four numbers in [0, 1), multiples of 2^-24 so that floats hold them.
std::array<double, 4> random_numbers(std::array<std::uint32_t, 4> counter);

}  // namespace lacquer::reference
