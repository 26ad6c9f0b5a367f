// A value of a material file together with where it stands, and its typed readings. Everything that
// does not fit throws Error with the file, line, JSON pointer and what would have fitted.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lacquer/material.h"
#include "material/document.h"
#include "material/ranges.h"

namespace lacquer {

// What all places of one file share.
struct ReadContext {
    std::string origin;            // the file, for messages
    std::filesystem::path folder;  // of the file, for textures
    std::vector<TextureReference> textures;
};

class Place {
 public:
    Place(ReadContext& context, const JsonValue& value, std::string pointer)
        : context_(&context), value_(&value), pointer_(std::move(pointer)) {}

    const std::string& pointer() const { return pointer_; }

    // An object whose every key is one of `allowed` or "comment" (a string, for people).
    void expect_object(const std::vector<std::string_view>& allowed) const;

    // Members of an object.
    std::optional<Place> find(std::string_view key) const;
    Place member(std::string_view key) const;  // fails where it is missing

    // An array's elements.
    std::vector<Place> elements() const;

    bool is_array() const;
    bool is_string() const;
    bool is_object() const;
    std::string string() const;

    // One of `choices`; fails listing them.
    std::string choice(const std::vector<std::string_view>& choices) const;

    // A number within `range`, or a texture in its place: {"texture": FILE, "channel": "r"}, where
    // r is meant if no channel is given.
    double number(const NumberRange& range) const;

    // An array of three of these; or one texture for all three, whose channels r, g and b are meant
    // if no channel is given.
    Rgb rgb(const NumberRange& range) const;

    // Whether the number is a texture's.
    bool is_texture() const;

    [[noreturn]] void fail(std::string_view problem) const;

 private:
    Place child(std::string_view token, const JsonValue& value) const;
    const JsonObject& object() const;
    void add_texture(const std::string& pointer, char default_channel) const;
    std::string description() const;

    ReadContext* context_;
    const JsonValue* value_;
    std::string pointer_;
};

}  // namespace lacquer
