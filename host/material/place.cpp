#include "material/place.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/error.h"

namespace lacquer {

namespace {

constexpr std::string_view kComment = "comment";

// A suggestion further than this from what was written would only puzzle.
constexpr std::size_t kMaxSuggestionDistance = 3;

// Insertions, deletions and replacements between two words (Levenshtein).
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i + 1);
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
        }
    }
    return row.back();
}

// "; did you mean 'albedo'?", or nothing where no word is near.
std::string suggestion(std::string_view word, const std::vector<std::string_view>& words) {
    std::size_t best = std::min(kMaxSuggestionDistance + 1, word.size());
    std::string text;
    for (const std::string_view candidate : words) {
        const std::size_t distance = edit_distance(word, candidate);
        if (distance >= best) continue;
        best = distance;
        text = fmt::format("; did you mean '{}'?", candidate);
    }
    return text;
}

// A key as a token of a JSON pointer (RFC 6901).
std::string pointer_token(std::string_view key) {
    std::string token;
    for (const char c : key) {
        if (c == '~')
            token += "~0";
        else if (c == '/')
            token += "~1";
        else
            token += c;
    }
    return token;
}

}  // namespace

void Place::expect_object(const std::vector<std::string_view>& allowed) const {
    std::vector<std::string_view> known = allowed;
    known.push_back(kComment);
    for (const JsonMember& member : object()) {
        const Place here = child(member.key, member.value);
        if (member.key == kComment) {
            here.string();
            continue;
        }
        if (std::ranges::find(known, member.key) != known.end()) continue;
        throw Error{fmt::format("{}:{}: {}: unknown key '{}', allowed here: {}{}", context_->origin,
                                member.line, here.pointer_, member.key, fmt::join(known, ", "),
                                suggestion(member.key, known))};
    }
}

std::optional<Place> Place::find(std::string_view key) const {
    for (const JsonMember& member : object())
        if (member.key == key) return child(key, member.value);
    return std::nullopt;
}

Place Place::member(std::string_view key) const {
    if (auto found = find(key)) return *std::move(found);
    fail(fmt::format("the key '{}' is missing", key));
}

std::vector<Place> Place::elements() const {
    const auto* array = std::get_if<JsonArray>(&value_->data);
    if (array == nullptr) fail(fmt::format("expected an array, found {}", description()));
    std::vector<Place> places;
    for (const JsonValue& value : *array)
        places.push_back(child(std::to_string(places.size()), value));
    return places;
}

bool Place::is_array() const {
    return std::holds_alternative<JsonArray>(value_->data);
}

bool Place::is_string() const {
    return std::holds_alternative<std::string>(value_->data);
}

bool Place::is_object() const {
    return std::holds_alternative<JsonObject>(value_->data);
}

std::string Place::string() const {
    const auto* text = std::get_if<std::string>(&value_->data);
    if (text == nullptr) fail(fmt::format("expected a string, found {}", description()));
    return *text;
}

std::string Place::choice(const std::vector<std::string_view>& choices) const {
    const std::string text = string();
    if (std::ranges::find(choices, text) == choices.end())
        fail(fmt::format("'{}' is not one of: {}{}", text, fmt::join(choices, ", "),
                         suggestion(text, choices)));
    return text;
}

double Place::number(const NumberRange& range) const {
    if (is_texture()) {
        add_texture(pointer_, 'r');
        return range.placeholder;
    }
    const auto* value = std::get_if<double>(&value_->data);
    if (value == nullptr)
        fail(fmt::format("expected a number or a texture, found {}", description()));
    if (!range.contains(*value)) fail(fmt::format("{} is outside {}", *value, range.text()));
    return *value;
}

Rgb Place::rgb(const NumberRange& range) const {
    if (is_texture()) {
        for (int i = 0; i < 3; ++i) add_texture(fmt::format("{}/{}", pointer_, i), "rgb"[i]);
        return {range.placeholder, range.placeholder, range.placeholder};
    }
    const auto* array = std::get_if<JsonArray>(&value_->data);
    if (array == nullptr || array->size() != 3)
        fail(fmt::format("expected an array of 3 numbers (red, green, blue), found {}",
                         description()));
    const std::vector<Place> channels = elements();
    return {channels[0].number(range), channels[1].number(range), channels[2].number(range)};
}

bool Place::is_texture() const {
    return is_object();
}

void Place::add_texture(const std::string& pointer, char default_channel) const {
    expect_object({"texture", "channel"});
    const Place file = member("texture");
    if (file.string().empty()) file.fail("the name of the texture's file is empty");
    char channel = default_channel;
    if (const auto chosen = find("channel")) channel = chosen->choice({"r", "g", "b", "a"})[0];
    context_->textures.push_back({pointer, context_->folder / file.string(), channel});
}

void Place::fail(std::string_view problem) const {
    throw Error{fmt::format("{}:{}: {}{}{}", context_->origin, value_->line, pointer_,
                            pointer_.empty() ? "" : ": ", problem)};
}

Place Place::child(std::string_view token, const JsonValue& value) const {
    return {*context_, value, pointer_ + "/" + pointer_token(token)};
}

const JsonObject& Place::object() const {
    const auto* object = std::get_if<JsonObject>(&value_->data);
    if (object == nullptr) fail(fmt::format("expected an object, found {}", description()));
    return *object;
}

std::string Place::description() const {
    struct Describe {
        std::string operator()(std::nullptr_t) const { return "null"; }
        std::string operator()(bool value) const { return value ? "true" : "false"; }
        std::string operator()(double value) const { return fmt::format("the number {}", value); }
        std::string operator()(const std::string& value) const {
            return fmt::format("the string \"{}\"", value);
        }
        std::string operator()(const JsonArray& value) const {
            return fmt::format("an array of {}", value.size());
        }
        std::string operator()(const JsonObject&) const { return "an object"; }
    };
    return std::visit(Describe{}, value_->data);
}

}  // namespace lacquer
