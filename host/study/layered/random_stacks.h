// Stacks of one to four coats at random: varnishes, glasses and glazes in any order.
#pragma once

#include <random>
#include <string>

#include "lacquer/material.h"

namespace lacquer::study {

enum class BaseKind { conductor, lambertian };

// Of the ranges that random_stacks_figure tells, and a direction.
struct RandomStack {
    Material material;
    double cos_theta = 1.0;
};

RandomStack random_stack(std::mt19937_64& generator, BaseKind kind, int coats);

// In one channel.
std::string describe(const RandomStack& stack, std::size_t channel);

}  // namespace lacquer::study
