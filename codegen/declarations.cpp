#include "codegen/declarations.h"

#include <regex>
#include <sstream>
#include <utility>

namespace lacquer::codegen {

namespace {

// "const vec3 wi, const vec3 wo" as types and names.
std::vector<Parameter> read_parameters(const std::string& list) {
    static const std::regex kParameter{R"((?:const\s+|in\s+)?(\w+)\s+(\w+(?:\[\w*\])?)\s*(?:,|$))"};
    std::vector<Parameter> parameters;
    for (std::sregex_iterator match{list.begin(), list.end(), kParameter}, end; match != end;
         ++match)
        parameters.push_back({(*match)[1], (*match)[2]});
    return parameters;
}

// Declares nothing where `name` stays empty. `line` may be continued by `lines`.
Declaration read_declaration(std::string line, std::istringstream& lines) {
    static const std::regex kConstant{R"(^const (\w+) (\w+) = (.*);.*$)"};
    static const std::regex kStructure{R"(^struct (\w+) \{.*$)"};
    static const std::regex kFunction{R"(^(\w+) (\w+)\(([^)]*)\) \{.*$)"};
    static const std::regex kFunctionStart{R"(^\w+ \w+\([^)]*$)"};
    for (std::string more; std::regex_match(line, kFunctionStart) && std::getline(lines, more);)
        line += more;
    Declaration declaration;
    std::smatch match;
    if (std::regex_match(line, match, kConstant)) {
        declaration.kind = Declaration::Kind::constant;
        declaration.type = match[1];
        declaration.name = match[2];
        declaration.value = match[3];
    } else if (std::regex_match(line, match, kStructure)) {
        declaration.kind = Declaration::Kind::structure;
        declaration.name = match[1];
    } else if (std::regex_match(line, match, kFunction)) {
        declaration.type = match[1];
        declaration.name = match[2];
        declaration.parameters = read_parameters(match[3]);
    }
    return declaration;
}

}  // namespace

SourceModule read_declarations(const std::string& file, const std::string& text) {
    SourceModule module{file, {}, {}};
    std::istringstream lines{text};
    std::vector<std::string> comment;
    bool after_blank = true;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("//")) {
            comment.push_back(line);
            continue;
        }
        // What stands above all code, with or without a blank line, describes the file.
        if (module.head.empty() && module.declarations.empty() && line.starts_with("#"))
            module.head = std::exchange(comment, {});
        Declaration declaration = read_declaration(line, lines);
        if (!declaration.name.empty()) {
            declaration.comment = comment;
            declaration.starts_group = after_blank;
            module.declarations.push_back(std::move(declaration));
        }
        comment.clear();
        after_blank = line.empty();
    }
    return module;
}

std::vector<SourceModule> read_declarations(const SourceTree& tree, const std::string& file) {
    std::vector<SourceModule> modules;
    for (const std::string& name : tree.closure(file))
        modules.push_back(read_declarations(name, tree.text(name)));
    return modules;
}

std::string first_sentence(const std::vector<std::string>& comment) {
    std::string text;
    for (const std::string& line : comment) {
        std::string words = line.substr(2);
        if (!words.empty() && words[0] == ' ') words.erase(0, 1);
        if (words.empty()) break;
        text += (text.empty() ? "" : " ") + words;
    }
    // A point ends a sentence where a capital follows, so that "et al. 2007" does not.
    static const std::regex kEnd{R"(\.(?= +[A-Z`0-9(]|$))"};
    std::smatch match;
    std::string::const_iterator from = text.cbegin();
    while (std::regex_search(from, text.cend(), match, kEnd)) {
        const std::string before{text.cbegin(), match[0].first};
        if (!before.ends_with("et al") && !before.ends_with("Eq")) return before + ".";
        from = match[0].second;
    }
    return text;
}

}  // namespace lacquer::codegen
