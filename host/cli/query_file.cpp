#include "cli/query_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <iostream>
#include <iterator>

#include "cli/options.h"
#include "core/error.h"
#include "core/file.h"

namespace lacquer {

namespace {

constexpr std::array<std::string_view, 6> kColumns{"wi_x", "wi_y", "wi_z", "wo_x", "wo_y", "wo_z"};

// Where a message points to.
struct Line {
    std::string_view origin;
    std::size_t number;

    [[noreturn]] void fail(std::string_view what) const {
        throw Error{fmt::format("{}:{}: {}", origin, number, what)};
    }
};

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kBlank = " \t\r";
    const std::size_t first = text.find_first_not_of(kBlank);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (std::size_t end; (end = text.find(separator)) != std::string_view::npos;) {
        parts.push_back(text.substr(0, end));
        text.remove_prefix(end + 1);
    }
    parts.push_back(text);
    return parts;
}

double parse_cell(const Line& line, std::size_t column, std::string_view cell) {
    std::string_view digits = trimmed(cell);
    if (digits.starts_with('+')) digits.remove_prefix(1);
    double value = 0.0;
    const auto [end, problem] =
        std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (problem != std::errc{} || end != digits.data() + digits.size() || !std::isfinite(value))
        line.fail(fmt::format("column {} ({}): '{}' is not a finite number", column + 1,
                              kColumns[column], trimmed(cell)));
    return value;
}

void require_unit(const Line& line, std::string_view name, const glm::dvec3& w) {
    const double length = glm::length(w);
    if (std::abs(length - 1.0) > kUnitTolerance)
        line.fail(
            fmt::format("columns {0}_x to {0}_z: the direction has length {1:.9g}, must be 1 "
                        "within {2}",
                        name, length, kUnitTolerance));
}

QueryRow parse_row(const Line& line, std::string_view text) {
    const std::vector<std::string_view> cells = split(text, ',');
    if (cells.size() != kColumns.size())
        line.fail(
            fmt::format("{} columns, must be {}: {}", cells.size(), kColumns.size(), kQueryHeader));
    std::array<double, kColumns.size()> values{};
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = parse_cell(line, i, cells[i]);
    QueryRow row{
        std::string{text}, {values[0], values[1], values[2]}, {values[3], values[4], values[5]}};
    require_unit(line, "wi", row.wi);
    require_unit(line, "wo", row.wo);
    return row;
}

void require_header(const Line& line, std::string_view text) {
    const std::vector<std::string_view> names = split(text, ',');
    for (std::size_t i = 0; i < kColumns.size(); ++i)
        if (i >= names.size() || trimmed(names[i]) != kColumns[i])
            line.fail(fmt::format("column {} of the header is '{}', must be '{}' of: {}", i + 1,
                                  i < names.size() ? trimmed(names[i]) : "", kColumns[i],
                                  kQueryHeader));
    if (names.size() != kColumns.size())
        line.fail(fmt::format("the header has {} columns, must be {}: {}", names.size(),
                              kColumns.size(), kQueryHeader));
}

}  // namespace

std::vector<QueryRow> parse_queries(std::string_view text, std::string_view origin) {
    std::vector<std::string_view> lines = split(text, '\n');
    while (!lines.empty() && trimmed(lines.back()).empty()) lines.pop_back();
    if (lines.empty())
        throw Error{fmt::format("{}: empty, must begin with: {}", origin, kQueryHeader)};
    require_header({origin, 1}, lines.front());
    if (lines.size() == 1) throw Error{fmt::format("{}: no queries below the header", origin)};
    std::vector<QueryRow> rows;
    rows.reserve(lines.size() - 1);
    for (std::size_t i = 1; i < lines.size(); ++i)
        rows.push_back(parse_row({origin, i + 1}, trimmed(lines[i])));
    return rows;
}

std::vector<QueryRow> read_queries(const std::filesystem::path& file) {
    if (file != "-") return parse_queries(read_file(file), file.string());
    const std::string text{std::istreambuf_iterator<char>{std::cin}, {}};
    return parse_queries(text, "standard input");
}

}  // namespace lacquer
