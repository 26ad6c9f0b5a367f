// Columns of text for a terminal.
#pragma once

#include <string>
#include <vector>

namespace lacquer {

enum class Align { left, right };

struct Column {
    std::string title;
    Align align = Align::left;
};

// The rows under their titles, two spaces between columns, no spaces at the ends of lines. Rows
// have as many cells as there are columns; widths count code points.
std::string format_table(const std::vector<Column>& columns,
                         const std::vector<std::vector<std::string>>& rows);

}  // namespace lacquer
