#include "material/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "core/error.h"

namespace lacquer {

namespace {

// `text` without what leads up to the first `end`, where it starts with `start`.
std::string_view without_prefix(std::string_view text, std::string_view start,
                                std::string_view end) {
    const std::size_t at = text.find(end);
    if (!text.starts_with(start) || at == std::string_view::npos) return text;
    return text.substr(at + end.size());
}

// Reads the text and keeps in `offset` how far the parser has come.
class CountingIterator {
 public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    CountingIterator(const char* text, std::size_t position, std::size_t* offset)
        : text_(text), position_(position), offset_(offset) {}

    reference operator*() const { return text_[position_]; }
    CountingIterator& operator++() {
        *offset_ = ++position_;
        return *this;
    }
    bool operator==(const CountingIterator& other) const { return position_ == other.position_; }
    bool operator!=(const CountingIterator& other) const { return position_ != other.position_; }

 private:
    const char* text_;
    std::size_t position_;
    std::size_t* offset_;
};

// Builds the tree from the parser's events. Each returns whether to go on.
class TreeBuilder {
 public:
    TreeBuilder(const std::string& text, const std::string& origin, const std::size_t& offset)
        : text_(text), origin_(origin), offset_(offset) {}

    bool null() { return add(nullptr); }
    bool boolean(bool value) { return add(value); }
    bool number_integer(std::int64_t value) { return add(static_cast<double>(value)); }
    bool number_unsigned(std::uint64_t value) { return add(static_cast<double>(value)); }
    bool number_float(double value, const std::string&) { return add(value); }
    bool string(std::string& value) { return add(std::move(value)); }
    bool binary(const nlohmann::json::binary_t&) { return false; }  // not in JSON texts

    bool start_object(std::size_t) { return open(JsonObject{}); }
    bool start_array(std::size_t) { return open(JsonArray{}); }
    bool end_object() { return close(); }
    bool end_array() { return close(); }

    bool key(std::string& name) {
        auto& members = std::get<JsonObject>(open_.back()->data);
        const auto same = [&](const JsonMember& member) { return member.key == name; };
        if (const auto first = std::ranges::find_if(members, same); first != members.end())
            fail(offset_,
                 fmt::format("the key '{}' is there already, on line {}", name, first->line));
        members.push_back({std::move(name), line_here(), {}});
        return true;
    }

    bool parse_error(std::size_t position, const std::string&,
                     const nlohmann::json::exception& error) {
        std::string_view reason = without_prefix(error.what(), "[", "] ");
        reason = without_prefix(reason, "parse error at", ": ");
        if (text_.find_first_not_of(" \t\r\n") == std::string::npos) reason = "the text is empty";
        fail(position, fmt::format("not valid JSON: {}", reason));
    }

    JsonValue take() { return std::move(root_); }

 private:
    template <typename Data>
    bool add(Data data) {
        place() = JsonValue{std::move(data), line_here()};
        return true;
    }

    template <typename Data>
    bool open(Data data) {
        if (open_.size() == kMaxJsonDepth)
            fail(offset_, fmt::format("nested deeper than {} levels", kMaxJsonDepth));
        JsonValue& value = place();
        value = JsonValue{std::move(data), line_here()};
        open_.push_back(&value);
        return true;
    }

    bool close() {
        open_.pop_back();
        return true;
    }

    // Where the next value belongs.
    JsonValue& place() {
        if (open_.empty()) return root_;
        if (auto* array = std::get_if<JsonArray>(&open_.back()->data)) return array->emplace_back();
        return std::get<JsonObject>(open_.back()->data).back().value;
    }

    // The line of the token just read. Its last character is left out: a number ends with the
    // character after it, which may be the end of the line. Called in the order of the text.
    int line_here() {
        for (; counted_ + 1 < offset_; ++counted_) line_ += text_[counted_] == '\n';
        return line_;
    }

    // `position` counts the characters read, the offending one included.
    [[noreturn]] void fail(std::size_t position, const std::string& problem) const {
        const std::size_t at = std::min(position == 0 ? 0 : position - 1, text_.size());
        const std::size_t newline = at == 0 ? std::string::npos : text_.rfind('\n', at - 1);
        const std::size_t start = newline == std::string::npos ? 0 : newline + 1;
        const auto line = 1 + std::count(text_.begin(), text_.begin() + std::ptrdiff_t(at), '\n');
        throw Error{fmt::format("{}:{}:{}: {}", origin_, line, at - start + 1, problem)};
    }

    const std::string& text_;
    const std::string& origin_;
    const std::size_t& offset_;
    JsonValue root_;
    std::vector<JsonValue*> open_;  // the arrays and objects around the next value
    std::size_t counted_ = 0;       // characters before this one are counted in line_
    int line_ = 1;
};

}  // namespace

JsonValue parse_json(const std::string& text, const std::string& origin) {
    std::size_t offset = 0;
    TreeBuilder builder{text, origin, offset};
    nlohmann::json::sax_parse(CountingIterator{text.data(), 0, &offset},
                              CountingIterator{text.data(), text.size(), &offset}, &builder);
    return builder.take();
}

}  // namespace lacquer
