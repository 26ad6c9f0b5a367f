#include "codegen/library.h"

#include <fmt/format.h>

#include <map>

namespace lacquer::codegen {

namespace {

bool is_public(const Declaration& declaration) {
    return declaration.kind == Declaration::Kind::function && declaration.name.starts_with("lq_");
}

// What users supply, for the compiler: no module declares it, so that it is not in the library.
constexpr std::string_view kStandIns =
    "uvec4 {}(const int index) {{ return uvec4(uint(index)); }}\n"
    "vec4 {}(const int index) {{ return vec4(float(index)); }}\n";

// A call with arguments that were never set, in a scope of its own.
std::string call(const Declaration& function) {
    std::string locals;
    std::string arguments;
    for (const Parameter& parameter : function.parameters) {
        locals += fmt::format("{} {}; ", parameter.type, parameter.name);
        arguments += arguments.empty() ? "" : ", ";
        arguments += parameter.name.substr(0, parameter.name.find('['));
    }
    return fmt::format("    {{ {}{}({}); }}\n", locals, function.name, arguments);
}

// A shader that includes `source` and makes `calls`.
std::string entry(const std::string& source, const std::string& calls) {
    return fmt::format(
        "#version 450\n"
        "#extension GL_GOOGLE_include_directive : require\n"
        "{}"
        "#include \"{}\"\n"
        "void main() {{\n{}}}\n",
        fmt::format(kStandIns, kTableAccess, kLayerAccess), source, calls);
}

}  // namespace

std::string library_entry(const std::string& source, const std::vector<SourceModule>& modules) {
    std::string calls;
    for (const SourceModule& module : modules)
        for (const Declaration& declaration : module.declarations)
            if (is_public(declaration)) calls += call(declaration);
    return entry(source, calls);
}

std::string function_entry(const std::string& source, const std::vector<SourceModule>& modules,
                           const std::string& name) {
    for (const SourceModule& module : modules)
        for (const Declaration& declaration : module.declarations)
            if (is_public(declaration) && declaration.name == name)
                return entry(source, call(declaration));
    return {};
}

std::vector<Function> public_functions(const text::Statements& statements,
                                       const std::vector<SourceModule>& modules,
                                       text::Dialect dialect) {
    std::map<std::string, std::string> signatures;
    for (const text::Statement& statement : statements) {
        const text::Definition definition = definition_of(statement, dialect);
        if (definition.kind == text::DefinitionKind::function)
            signatures[definition.name] = join(statement.head);
    }
    std::vector<Function> functions;
    for (const SourceModule& module : modules)
        for (const Declaration& declaration : module.declarations)
            if (is_public(declaration) && signatures.contains(declaration.name))
                functions.push_back({declaration.name,
                                     signatures[declaration.name],
                                     first_sentence(declaration.comment),
                                     {}});
    return functions;
}

}  // namespace lacquer::codegen
