#include "codegen/text/token.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace lacquer::codegen::text {

namespace {

bool is_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool is_digit(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

// Length of the number at the start of `rest`: digits, point, exponent and suffix.
std::size_t number_length(std::string_view rest) {
    std::size_t length = 0;
    const bool hexadecimal = rest.starts_with("0x");
    while (length < rest.size()) {
        const char c = rest[length];
        const bool exponent = !hexadecimal && (c == 'e' || c == 'E');
        if (exponent && length + 1 < rest.size() &&
            (rest[length + 1] == '-' || rest[length + 1] == '+')) {
            length += 2;
            continue;
        }
        // `0.0f.xxx`: a second point begins a swizzle, not a fraction.
        const bool point = c == '.' && rest.substr(0, length).find('.') == std::string_view::npos;
        if (!is_word(c) && !point) break;
        ++length;
    }
    return length;
}

std::size_t punctuation_length(std::string_view rest) {
    static constexpr std::array<std::string_view, 17> kLong{"++", "--", "+=", "-=", "*=", "/=",
                                                            "==", "!=", "<=", ">=", "&&", "||",
                                                            "<<", ">>", "->", "::", "|="};
    return std::ranges::find(kLong, rest.substr(0, 2)) == kLong.end() ? 1 : 2;
}

}  // namespace

Tokens tokenize(std::string_view source) {
    Tokens tokens;
    bool space = false;
    for (std::size_t i = 0; i < source.size();) {
        const std::string_view rest = source.substr(i);
        if (std::isspace(static_cast<unsigned char>(rest[0])) != 0) {
            space = true;
            ++i;
            continue;
        }
        Token token{.space = space};
        std::size_t length = 0;
        if (rest[0] == '#' || rest.starts_with("//")) {
            token.kind = TokenKind::line;
            length = std::min(rest.find('\n'), rest.size());
        } else if (is_digit(rest[0])) {
            token.kind = TokenKind::number;
            length = number_length(rest);
        } else if (is_word(rest[0])) {
            token.kind = TokenKind::identifier;
            while (length < rest.size() && is_word(rest[length])) ++length;
        } else {
            length = punctuation_length(rest);
        }
        token.text = rest.substr(0, length);
        tokens.push_back(std::move(token));
        i += length;
        space = false;
    }
    return tokens;
}

std::string join(const Tokens& tokens) {
    std::string line;
    for (const Token& token : tokens) {
        if (token.space && !line.empty()) line += ' ';
        line += token.text;
    }
    return line;
}

Tokens slice(const Tokens& tokens, std::size_t first, std::size_t last) {
    return {tokens.begin() + static_cast<std::ptrdiff_t>(first),
            tokens.begin() + static_cast<std::ptrdiff_t>(std::max(first, last))};
}

void substitute(Tokens& tokens, std::string_view name, const Tokens& value) {
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        if (!tokens[i].is(name) || !is_free_name(tokens, i)) continue;
        Tokens group = value;
        group.front().space = false;
        group.insert(group.begin(), Token{.text = "(", .space = tokens[i].space});
        group.push_back(Token{.text = ")"});
        const auto at = tokens.erase(tokens.begin() + static_cast<std::ptrdiff_t>(i));
        tokens.insert(at, group.begin(), group.end());
        i += group.size() - 1;
    }
}

std::size_t closing(const Tokens& tokens, std::size_t open) {
    int depth = 0;
    for (std::size_t i = open; i < tokens.size(); ++i) {
        if (tokens[i].is("(") || tokens[i].is("[") || tokens[i].is("{")) ++depth;
        if (tokens[i].is(")") || tokens[i].is("]") || tokens[i].is("}")) --depth;
        if (depth == 0) return i;
    }
    return tokens.size();
}

bool is_free_name(const Tokens& tokens, std::size_t index) {
    return tokens[index].kind == TokenKind::identifier &&
           (index == 0 || !tokens[index - 1].is("."));
}

std::size_t count_mentions(const Tokens& tokens, std::string_view name) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < tokens.size(); ++i)
        if (tokens[i].is(name) && is_free_name(tokens, i)) ++count;
    return count;
}

bool mentions(const Tokens& tokens, std::string_view name) {
    return count_mentions(tokens, name) > 0;
}

}  // namespace lacquer::codegen::text
