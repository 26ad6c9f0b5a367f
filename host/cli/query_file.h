// Queries as rows of comma-separated values.
#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace lacquer {

inline constexpr std::string_view kQueryHeader = "wi_x,wi_y,wi_z,wo_x,wo_y,wo_z";

struct QueryRow {
    std::string text;  // as it stood in the file
    glm::dvec3 wi{}, wo{};
};

// Reads the rows under the header kQueryHeader. Throws Error with `origin`, line and column for
// another header, a row of another number of cells, what is not a finite number, a direction whose
// length is not 1 within kUnitTolerance, or no rows at all. Lines may end in CR LF.
std::vector<QueryRow> parse_queries(std::string_view text, std::string_view origin);

// The same from a file, or from the standard input where it is "-".
std::vector<QueryRow> read_queries(const std::filesystem::path& file);

}  // namespace lacquer
