// A JSON text as a tree that remembers the line of every value, so that what is wrong with a value
// can be reported where it stands.
#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

namespace lacquer {

struct JsonValue;
struct JsonMember;
using JsonArray = std::vector<JsonValue>;
using JsonObject = std::vector<JsonMember>;  // in the order of the text; keys are unique

struct JsonValue {
    std::variant<std::nullptr_t, bool, double, std::string, JsonArray, JsonObject> data;
    int line = 1;
};

struct JsonMember {
    std::string key;
    int line = 1;
    JsonValue value;
};

// Parses strict JSON: no comments, no NaN, no duplicate keys, at most kMaxJsonDepth levels. Throws
// Error with `origin`, line and column.
JsonValue parse_json(const std::string& text, const std::string& origin);

// No file of ours nests deeper than 10; a limit keeps a hostile one from exhausting the stack.
inline constexpr std::size_t kMaxJsonDepth = 32;

}  // namespace lacquer
