#include "core/table.h"

#include <algorithm>
#include <cassert>

namespace lacquer {

namespace {

// Code points of UTF-8 text: bytes that do not continue one.
std::size_t text_width(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u;
    }));
}

std::string padded(const std::string& text, Align align, std::size_t width) {
    const std::string space(width - text_width(text), ' ');
    return align == Align::left ? text + space : space + text;
}

std::string table_line(const std::vector<Column>& columns, const std::vector<std::size_t>& widths,
                       const std::vector<std::string>& cells) {
    assert(cells.size() == columns.size());
    std::string line;
    for (std::size_t i = 0; i < columns.size(); ++i)
        line += (i == 0 ? "" : "  ") + padded(cells[i], columns[i].align, widths[i]);
    line.erase(line.find_last_not_of(' ') + 1);
    return line + "\n";
}

}  // namespace

std::string format_table(const std::vector<Column>& columns,
                         const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::string> titles;
    std::vector<std::size_t> widths;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        titles.push_back(columns[i].title);
        widths.push_back(text_width(columns[i].title));
        for (const auto& row : rows) widths[i] = std::max(widths[i], text_width(row.at(i)));
    }
    std::string table = table_line(columns, widths, titles);
    for (const auto& row : rows) table += table_line(columns, widths, row);
    return table;
}

}  // namespace lacquer
