// The parts of the HTML report.
#pragma once

#include <string>
#include <string_view>

#include "compare/compare.h"
#include "image/image.h"

namespace lacquer {

// What every section says in the same way.
std::string error_html(double error);  // "6.4e-5", "not finite"
std::string status_pill(Status status);
std::string image_html(std::string_view kind, std::string_view png, int width, int height,
                       std::string_view alternative);
std::string material_anchor(const NamedMaterial& material);

// Colour of an error by its margin to the limit: an attribute for style.
std::string margin_style(double error, double limit);

// The lit sphere of material `index` as the reference sees it, `shrink` times smaller.
std::string reference_sphere_png(const CompareResult& result, std::size_t index, int shrink);

// The picture of a sphere or of slices, as a display shows it.
Image picture(const QueryGrid& grid, const GridValues& values);

std::string backends_section(const CompareResult& result);
std::string matrix_section(const CompareResult& result);
std::string distribution_section(const CompareResult& result);
std::string material_section(const CompareResult& result, std::size_t index);

}  // namespace lacquer
