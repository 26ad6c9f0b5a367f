// What a shader source file declares and how it documents it.
#pragma once

#include <string>
#include <vector>

#include "codegen/source_tree.h"

namespace lacquer::codegen {

struct Parameter {
    std::string type;
    std::string name;
};

struct Declaration {
    enum class Kind { constant, structure, function };
    Kind kind = Kind::function;
    std::string name;
    std::vector<std::string> comment;  // its lines, with their slashes
    std::string type;                  // of a constant, or returned by a function
    std::string value;                 // of a constant, as it stands
    std::vector<Parameter> parameters;
    bool starts_group = false;  // a blank line stands above it
};

struct SourceModule {
    std::string file;
    std::vector<std::string> head;  // the comment that opens it
    std::vector<Declaration> declarations;
};

// The declarations at the top of a file, in their order.
SourceModule read_declarations(const std::string& file, const std::string& text);

// Of `file` and all that it includes.
std::vector<SourceModule> read_declarations(const SourceTree& tree, const std::string& file);

// The first sentence of a comment, without slashes.
std::string first_sentence(const std::vector<std::string>& comment);

}  // namespace lacquer::codegen
