// The words of a shading language. Spacing is kept from the text they came from, so that printing
// them needs no knowledge of the language.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lacquer::codegen::text {

enum class TokenKind {
    identifier,  // keywords included
    number,
    punctuation,
    line,  // a preprocessor directive or a comment, to the end of its line
};

struct Token {
    TokenKind kind = TokenKind::punctuation;
    std::string text{};
    bool space = false;  // white space stood before it

    bool is(std::string_view other) const { return text == other; }
};

using Tokens = std::vector<Token>;

// Splits `source` into tokens.
Tokens tokenize(std::string_view source);

// The tokens as one line.
std::string join(const Tokens& tokens);

// Tokens [first, last); none where last comes before first.
Tokens slice(const Tokens& tokens, std::size_t first, std::size_t last);

// Puts `value`, in parentheses, in the place of every free `name`.
void substitute(Tokens& tokens, std::string_view name, const Tokens& value);

// The index of the bracket that closes the one at `open`; tokens.size() where there is none.
std::size_t closing(const Tokens& tokens, std::size_t open);

// Whether any token is the identifier `name`, not counting members (`.name`).
bool mentions(const Tokens& tokens, std::string_view name);

// How often it occurs.
std::size_t count_mentions(const Tokens& tokens, std::string_view name);

// Whether the token at `index` names a variable, function or type rather than a member.
bool is_free_name(const Tokens& tokens, std::size_t index);

}  // namespace lacquer::codegen::text
