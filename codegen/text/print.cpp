#include "codegen/text/print.h"

#include <map>
#include <optional>
#include <tuple>

namespace lacquer::codegen::text {

namespace {

constexpr std::size_t kIndent = 4;

// How loosely a token holds what stands on either side: the higher, the better to break there.
int looseness(const Token& token) {
    static const std::map<std::string_view, int> kLooseness{
        {",", 9},  {";", 9},  {"(", 9},  {"{", 9},  {"?", 8},  {":", 8},  {"||", 7},
        {"&&", 6}, {"==", 5}, {"!=", 5}, {"<=", 5}, {">=", 5}, {"<", 5},  {">", 5},
        {"+", 4},  {"-", 4},  {"*", 3},  {"/", 3},  {"=", 2},  {"+=", 2}, {"-=", 2}};
    const auto found = kLooseness.find(token.text);
    if (found == kLooseness.end() || token.kind != TokenKind::punctuation) return 0;
    const bool tight = token.is(",") || token.is(";") || token.is("(") || token.is("{");
    return tight || token.space ? found->second : 0;  // `-x` and `array<f32>` have no space
}

bool opens(const Token& token) {
    return token.is("(") || token.is("[") || token.is("{");
}

bool closes(const Token& token) {
    return token.is(")") || token.is("]") || token.is("}");
}

std::size_t width_of(const Token& token) {
    return token.text.size() + (token.space ? 1 : 0);
}

// A line to break: tokens from `first` on, of which those before `limit` fit.
struct Line {
    const Tokens& tokens;
    std::size_t first;
    std::size_t limit;
    std::size_t column;  // where it starts
    std::size_t room;    // columns of the lines that follow
};

// How good it is to break after the token at `index`, `depth` brackets deep, at `column`: as
// shallow as possible, then where the parts are held together most loosely. Nothing where it is no
// place.
std::optional<std::tuple<int, int>> break_rank(const Line& line, std::size_t index, int depth,
                                               std::size_t column) {
    const Token& token = line.tokens[index];
    const Token& next = line.tokens[index + 1];
    // Lines end with an operator, but begin with the parts of a choice.
    const bool before_choice = (next.is("?") || next.is(":")) && next.space;
    const bool sign = index == line.first || token.is("?") || token.is(":") ||
                      line.tokens[index - 1].is("return");
    if (sign && !before_choice) return std::nullopt;
    const int loose = looseness(before_choice ? next : token);
    if (loose == 0) return std::nullopt;
    std::size_t rest = 0;
    for (std::size_t i = index + 1; i < line.tokens.size(); ++i) rest += width_of(line.tokens[i]);
    const bool rest_fits = rest <= line.room;
    const bool assignment = loose == looseness({.text = "=", .space = true});
    if (assignment && !rest_fits) return std::nullopt;
    // A short line followed by another that needs breaking reads badly, but for lists.
    const bool call =
        token.is("{") || (token.is("(") && line.tokens[index - 1].kind == TokenKind::identifier);
    if (!rest_fits && !call && !token.is(",") && column < kColumns * 2 / 5) return std::nullopt;
    return std::tuple{-depth, loose};
}

// The token to begin the next line with; 0 where there is no place to break.
std::size_t find_break(const Line& line) {
    std::size_t best = 0;
    std::tuple<int, int> best_rank;
    int depth = 0;
    std::size_t column = line.column;
    for (std::size_t i = line.first; i < line.limit && i + 1 < line.tokens.size(); ++i) {
        if (opens(line.tokens[i])) ++depth;
        if (closes(line.tokens[i])) --depth;
        column += width_of(line.tokens[i]);
        const auto rank = break_rank(line, i, depth, column);
        if (!rank || (best != 0 && *rank < best_rank)) continue;
        best = i + 1;
        best_rank = *rank;
    }
    return best;
}

class Printer {
 public:
    std::string top_level(const Statements& statements) {
        const Statement* previous = nullptr;
        for (const Statement& statement : statements) {
            if (previous != nullptr && wants_blank(*previous, statement)) text_ += '\n';
            print(statement, 0, nullptr);
            previous = &statement;
        }
        return std::move(text_);
    }

 private:
    // Definitions with a body or a comment stand apart.
    static bool wants_blank(const Statement& previous, const Statement& next) {
        if (next.gap) return true;
        if (next.is_line() || previous.is_line()) return next.is_line() != previous.is_line();
        return previous.has_block || next.has_block || !next.above.empty();
    }

    void block(const Statements& statements, std::size_t indent) {
        const Statement* previous = nullptr;
        for (const Statement& statement : statements) {
            print(statement, indent, previous);
            previous = &statement;
        }
    }

    void print(const Statement& statement, std::size_t indent, const Statement* previous) {
        const std::string margin(indent, ' ');
        for (const std::string& line : statement.above) text_ += margin + line + '\n';
        if (statement.head.empty() && !statement.has_block) return;  // a comment on its own
        const bool joins = statement.starts_with("else") && previous != nullptr &&
                           previous->has_block && text_.ends_with("}\n");
        if (joins) {
            text_.resize(text_.size() - 1);
            text_ += ' ';
        } else {
            text_ += margin;
        }
        // What opens a block is continued further in, so that it stands apart from the block.
        const std::size_t continued = indent + (statement.has_block ? 2 : 1) * kIndent;
        tokens(statement.head, continued, statement.end.size() + (statement.has_block ? 2 : 0));
        if (statement.has_block) {
            text_ += statement.head.empty() ? "{\n" : " {\n";
            block(statement.body, indent + kIndent);
            text_ += margin + "}";
            if (!statement.tail.empty()) text_ += " " + join(statement.tail);
        }
        text_ += statement.end + "\n";
    }

    // How many tokens from `first` on fit on a line that has reached `column`.
    static std::size_t fitting(const Tokens& tokens, std::size_t first, std::size_t column,
                               std::size_t reserve) {
        for (std::size_t i = first; i < tokens.size(); ++i) {
            column += width_of(tokens[i]) - (i == first && tokens[i].space ? 1 : 0);
            if (column + (i + 1 == tokens.size() ? reserve : 0) > kColumns) return i;
        }
        return tokens.size();
    }

    // Prints tokens after the margin, in as many lines as they need, the others from `next_column`
    // on, with room for `reserve` more columns at the end.
    void tokens(const Tokens& tokens, std::size_t next_column, std::size_t reserve) {
        std::size_t column = text_.size() - (text_.rfind('\n') + 1);
        for (std::size_t first = 0; first < tokens.size();) {
            const std::size_t limit = fitting(tokens, first, column, reserve);
            std::size_t next = tokens.size();
            if (limit < tokens.size() && tokens[first].kind != TokenKind::line) {
                next = find_break({tokens, first, limit, column, kColumns - next_column - reserve});
                if (next == 0) next = tokens.size();
            }
            text_ += join({tokens.begin() + static_cast<std::ptrdiff_t>(first),
                           tokens.begin() + static_cast<std::ptrdiff_t>(next)});
            first = next;
            if (first == tokens.size()) break;
            text_ += '\n' + std::string(next_column, ' ');
            column = next_column;
        }
    }

    std::string text_;
};

}  // namespace

std::string print(const Statements& statements) {
    return Printer{}.top_level(statements);
}

}  // namespace lacquer::codegen::text
