// Published refractive indices of metals: tables/optical_constants.json, built into the library.
#pragma once

#include <span>
#include <string>

#include "lacquer/material.h"

namespace lacquer {

// Absolute index eta + i kappa per colour channel.
struct OpticalConstants {
    std::string metal;
    Rgb eta, kappa;
};

// All metals of the table, in its order.
std::span<const OpticalConstants> all_optical_constants();

// Nothing where the table does not have the metal.
const OpticalConstants* find_optical_constants(std::string_view metal);

}  // namespace lacquer
