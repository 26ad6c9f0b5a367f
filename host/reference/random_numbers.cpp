#include "reference/random_numbers.h"

namespace lacquer::reference {

namespace {

// Each word takes the product of its two neighbours in turn.
void stir(std::array<std::uint32_t, 4>& words) {
    words[0] += words[1] * words[3];
    words[1] += words[2] * words[0];
    words[2] += words[0] * words[1];
    words[3] += words[1] * words[2];
}

}  // namespace

std::array<double, 4> random_numbers(std::array<std::uint32_t, 4> counter) {
    for (std::uint32_t& word : counter) word = word * 1664525u + 1013904223u;
    stir(counter);
    for (std::uint32_t& word : counter) word ^= word >> 16;
    stir(counter);
    std::array<double, 4> numbers{};
    for (std::size_t n = 0; n < numbers.size(); ++n) numbers[n] = (counter[n] >> 8) * 0x1p-24;
    return numbers;
}

}  // namespace lacquer::reference
