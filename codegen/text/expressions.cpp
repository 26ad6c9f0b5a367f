#include "codegen/text/expressions.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>

namespace lacquer::codegen::text {

namespace {

// How tightly operators bind; only those whose order every reader knows.
constexpr int kOutside = 0;  // no operator: a bracket, a comma, an assignment
constexpr int kTernary = 1;
constexpr int kOr = 2;
constexpr int kAnd = 3;
constexpr int kComparison = 4;
constexpr int kSum = 6;
constexpr int kProduct = 7;
constexpr int kUnary = 8;
constexpr int kPrimary = 9;
constexpr int kUntouchable = -1;  // an operator whose parentheses stay beside other operators
constexpr int kNever = -2;        // parentheses that mean something else

int binary_precedence(const Token& token) {
    if (!token.space) return kUntouchable;  // `bitcast<u32>(...)`
    if (token.is("*") || token.is("/")) return kProduct;
    if (token.is("+") || token.is("-")) return kSum;
    if (token.is("<") || token.is(">") || token.is("<=") || token.is(">=")) return kComparison;
    if (token.is("==") || token.is("!=")) return kComparison;
    if (token.is("?") || token.is(":")) return kTernary;
    if (token.is("&&")) return kAnd;
    return token.is("||") ? kOr : kUntouchable;
}

bool opens(const Token& token) {
    return token.is("(") || token.is("[") || token.is("{");
}

bool is_operand_end(const Token& token) {
    return token.kind == TokenKind::number || token.is(")") || token.is("]") ||
           (token.kind == TokenKind::identifier && !token.is("return"));
}

bool is_assignment(const Token& token) {
    static constexpr std::array<std::string_view, 5> kAssignments{"=", "+=", "-=", "*=", "/="};
    return std::ranges::find(kAssignments, token.text) != kAssignments.end();
}

// Precedence of what stands before the '(' at `open`.
int left_precedence(const Tokens& tokens, std::size_t open) {
    if (open == 0) return kOutside;
    const Token& token = tokens[open - 1];
    if (opens(token) || token.is(",") || token.is(";") || token.is("return")) return kOutside;
    if (is_assignment(token)) return kOutside;
    const bool sign = token.is("-") || token.is("!");
    if (sign && (open == 1 || !is_operand_end(tokens[open - 2]))) return kUnary;
    return binary_precedence(token);
}

// Precedence of what stands after the ')' at `close`.
int right_precedence(const Tokens& tokens, std::size_t close) {
    if (close + 1 == tokens.size()) return kOutside;
    const Token& token = tokens[close + 1];
    if (token.is(")") || token.is("]") || token.is("}") || token.is(",") || token.is(";"))
        return kOutside;
    return binary_precedence(token);
}

bool is_type_name(const Token& token) {
    static constexpr std::array<std::string_view, 4> kTypes{"float", "int", "uint", "bool"};
    return std::ranges::find(kTypes, token.text) != kTypes.end();
}

// Precedence of the loosest operator between the parentheses.
int inner_precedence(const Tokens& tokens, std::size_t open, std::size_t close) {
    int loosest = kPrimary;
    for (std::size_t i = open + 1; i < close; ++i) {
        const Token& token = tokens[i];
        if (opens(token)) {
            i = closing(tokens, i);
            continue;
        }
        if (token.is(",") || is_assignment(token)) return kNever;
        if (token.kind != TokenKind::punctuation || token.is(".")) {
            if (is_type_name(token) && !(i + 1 < close && tokens[i + 1].is("(")))
                return kNever;  // a cast
            continue;
        }
        const bool binary = i > open + 1 && is_operand_end(tokens[i - 1]);
        const int precedence = binary                           ? binary_precedence(token)
                               : token.is("-") || token.is("!") ? kUnary
                                                                : kUntouchable;
        if (precedence == kUntouchable) return kUntouchable;
        loosest = std::min(loosest, precedence);
    }
    return loosest;
}

// Whether `tokens` at `index` begins an operand, so that `(T)` before it may be a cast.
bool is_operand_start(const Tokens& tokens, std::size_t index) {
    return index < tokens.size() &&
           (tokens[index].kind != TokenKind::punctuation || tokens[index].is("("));
}

bool is_removable(const Tokens& tokens, std::size_t open, std::size_t close) {
    if (open > 0 && is_operand_end(tokens[open - 1])) return false;  // a call, `if (`, `for (`
    if (open > 0 && tokens[open - 1].is(">") && !tokens[open - 1].space) return false;
    if (is_operand_start(tokens, close + 1)) return false;
    const int inner = inner_precedence(tokens, open, close);
    if (inner == kPrimary) return true;
    const int left = left_precedence(tokens, open);
    const int right = right_precedence(tokens, close);
    if (left == kOutside && right == kOutside) return inner != kNever;
    if (inner < kOutside || left < kOutside || right < kOutside) return false;
    // `a - -b` would be hard to read.
    const bool signed_operand = tokens[open + 1].is("-") && left >= kSum;
    // Nested choices and comparisons read better apart, and so do "and" within "or".
    const bool nested = (inner == kTernary && (left > kOutside || right > kOutside)) ||
                        (inner == kComparison && (left == kComparison || right == kComparison)) ||
                        (inner == kAnd && (left == kOr || right == kOr));
    return !signed_operand && !nested && inner > left && inner >= right;
}

// The number of components of a vector type of floats; 0 for other words.
std::size_t vector_width(const Token& token) {
    static constexpr std::array<std::string_view, 9> kVectors{
        "vec2", "vec3", "vec4", "vec2f", "vec3f", "vec4f", "float2", "float3", "float4"};
    if (std::ranges::find(kVectors, token.text) == kVectors.end()) return 0;
    return static_cast<std::size_t>(token.text[token.text.find_last_of("234")] - '0');
}

// The letters of `name.xy`, where tokens [first, last] are that: names, members and indices only.
std::string components_of(const Tokens& tokens, std::size_t first, std::size_t last) {
    if (last < first + 2 || !tokens[last - 1].is(".")) return {};
    for (std::size_t i = first; i < last; ++i)
        if (tokens[i].is("(") || tokens[i].is(",") || (i == first && opens(tokens[i]))) return {};
    int depth = 0;
    for (std::size_t i = first; i < last; ++i) {
        if (tokens[i].is("[")) ++depth;
        if (tokens[i].is("]")) --depth;
        const bool part = tokens[i].kind == TokenKind::identifier || tokens[i].is(".");
        if (depth == 0 && !part && !tokens[i].is("]")) return {};
    }
    const std::string& letters = tokens[last].text;
    return letters.find_first_not_of("xyzw") == std::string::npos ? letters : std::string{};
}

bool same_words(const Tokens& a, const Tokens& b) {
    return std::ranges::equal(a, b, {}, &Token::text, &Token::text);
}

}  // namespace

void remove_parentheses(Tokens& tokens) {
    for (std::size_t open = 0; open < tokens.size(); ++open) {
        if (!tokens[open].is("(")) continue;
        const std::size_t close = closing(tokens, open);
        if (close >= tokens.size() || close == open + 1 || !is_removable(tokens, open, close))
            continue;
        tokens[open + 1].space = tokens[open].space;
        tokens.erase(tokens.begin() + static_cast<std::ptrdiff_t>(close));
        tokens.erase(tokens.begin() + static_cast<std::ptrdiff_t>(open));
        --open;
    }
}

std::string shortest_float(const std::string& text) {
    const bool hexadecimal = text.starts_with("0x");
    if (hexadecimal || text.find_first_of(".ef") == std::string::npos) return text;
    const std::string suffix = text.ends_with('f') ? "f" : "";
    const float value = std::strtof(text.c_str(), nullptr);
    std::array<char, 64> digits{};
    const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    std::string decimal{digits.data(), end};
    std::string exponent;
    if (const std::size_t e = decimal.find('e'); e != std::string::npos) {
        exponent = "e" + std::to_string(std::atoi(decimal.c_str() + e + 1));
        decimal.resize(e);
    }
    if (decimal.find('.') == std::string::npos) decimal += ".0";
    return decimal + exponent + suffix;
}

void join_components(Tokens& tokens) {
    for (std::size_t i = 0; i + 5 < tokens.size(); ++i) {
        const std::size_t width = vector_width(tokens[i]);
        if (width == 0 || !tokens[i + 1].is("(")) continue;
        const std::size_t close = closing(tokens, i + 1);
        std::string components;
        Tokens base;
        for (std::size_t first = i + 2; first < close;) {
            std::size_t last = first;  // of this argument
            while (last + 1 < close && !tokens[last + 1].is(",")) ++last;
            const std::string letters = components_of(tokens, first, last);
            const Tokens argument = slice(tokens, first, last - std::min(last, std::size_t{1}));
            const bool same = base.empty() || same_words(base, argument);
            if (letters.empty() || !same) {
                components.clear();
                break;
            }
            base = argument;
            components += letters;
            first = last + 2;
        }
        if (components.size() != width) continue;
        base.front().space = tokens[i].space;
        base.push_back({.text = "."});
        base.push_back({.kind = TokenKind::identifier, .text = components});
        const auto at = tokens.begin() + static_cast<std::ptrdiff_t>(i);
        const auto rest = tokens.erase(at, tokens.begin() + static_cast<std::ptrdiff_t>(close) + 1);
        tokens.insert(rest, base.begin(), base.end());
    }
}

void join_splats(Tokens& tokens) {
    for (std::size_t i = 0; i + 3 < tokens.size(); ++i) {
        const std::size_t count = vector_width(tokens[i]);
        if (count == 0 || !tokens[i + 1].is("(")) continue;
        const std::size_t close = closing(tokens, i + 1);
        const Token& first = tokens[i + 2];
        const bool constant = first.kind == TokenKind::number || first.text.starts_with("LQ_");
        if (!constant || close != i + 2 * count + 1) continue;
        bool same = true;
        for (std::size_t k = i + 4; k < close; k += 2) same = same && tokens[k].is(first.text);
        if (!same) continue;
        const auto at = tokens.begin() + static_cast<std::ptrdiff_t>(i);
        tokens.erase(at + 3, tokens.begin() + static_cast<std::ptrdiff_t>(close));
    }
}

void shorten_numbers(Tokens& tokens) {
    for (Token& token : tokens)
        if (token.kind == TokenKind::number) token.text = shortest_float(token.text);
}

}  // namespace lacquer::codegen::text
