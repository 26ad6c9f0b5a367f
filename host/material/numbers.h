// The numbers of a material under the JSON pointers they have in its file.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "lacquer/material.h"
#include "material/ranges.h"

namespace lacquer {

// Called with each number: its JSON pointer, itself, and its range. A pair of alphas has the
// pointers ".../alpha/0" and ".../alpha/1", even where the file gives one number for both.
using NumberVisitor =
    std::function<void(const std::string& pointer, double& value, const NumberRange& range)>;

// Visits every number that a file can set: not the weight of a blend's last stratum.
void visit_numbers(Material& material, const NumberVisitor& visitor);

// The material with `value` at `pointer`, or at each element of the array that `pointer` names.
// This is how a texture is applied at a point. Throws Error where no number stands there, where
// `value` is out of its range, or where the material as a whole would no longer be valid.
Material with_number(const Material& material, std::string_view pointer, double value);

// The material with every number rounded to the nearest float.
Material rounded_to_float(const Material& material);

// The same after dividing every index by that of the exterior, which becomes 1: the material as the
// shaders get it. Near critical angles it matters that the quotients are what is rounded.
Material as_shaders_read(const Material& material);

}  // namespace lacquer
