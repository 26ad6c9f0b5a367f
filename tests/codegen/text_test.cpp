// How text is read, tidied and printed: what the rewrites do, and what they must leave alone.
#include <gmock/gmock.h>

#include <cstdlib>

#include "codegen/declarations.h"
#include "codegen/emit.h"
#include "codegen/text/expressions.h"
#include "codegen/text/print.h"
#include "codegen/text/tree.h"

namespace lacquer::test {
namespace {

using codegen::text::Dialect;
using codegen::text::Tokens;

std::string printed(const std::string& source, Dialect dialect = Dialect::glsl) {
    return print(codegen::text::parse(source, dialect));
}

std::string tidied(const std::string& source, Dialect dialect = Dialect::glsl) {
    auto statements = codegen::text::parse(source, dialect);
    codegen::tidy_c_family(statements, dialect);
    return print(statements);
}

std::string without_parentheses(const std::string& expression) {
    Tokens tokens = codegen::text::tokenize(expression);
    codegen::text::remove_parentheses(tokens);
    return join(tokens);
}

TEST(Text, ParenthesesGoWhereReadingStaysTheSame) {
    EXPECT_EQ(without_parentheses("x = ((a * b) + (c / d))"), "x = a * b + c / d");
    EXPECT_EQ(without_parentheses("x = (((a * b) * c) / d)"), "x = a * b * c / d");
    EXPECT_EQ(without_parentheses("return ((-a) * a)"), "return -a * a");
    EXPECT_EQ(without_parentheses("x = (a >= 0.0) ? b : c"), "x = a >= 0.0 ? b : c");
    EXPECT_EQ(without_parentheses("f((a), (b + c))"), "f(a, b + c)");
    EXPECT_EQ(without_parentheses("x = -(log(y))"), "x = -log(y)");
}

TEST(Text, ParenthesesStayWhereReadingWouldChange) {
    for (const char* expression :
         {"x = a * (b + c)", "x = a - (b - c)", "x = a - (b + c)", "x = a / (b * c)",
          "x = a * (b / c)", "x = -(a + b)", "x = (a + b).x", "x = !(a > b)", "if (a > b)",
          "x = a - (-b)", "x = (a ? b : c) + d", "x = (a < b) == c", "x = (a << b) + c",
          "x = float2(a, b)", "x = bitcast<u32>(a)", "x = (float)a", "x = (a && b) || c"})
        EXPECT_EQ(without_parentheses(expression), expression);
}

TEST(Text, NumbersReadBackAsTheSameFloat) {
    EXPECT_EQ(codegen::text::shortest_float("0.3183098733425140380859375"), "0.31830987");
    EXPECT_EQ(codegen::text::shortest_float("1.0"), "1.0");
    EXPECT_EQ(codegen::text::shortest_float("40.0f"), "40.0f");
    EXPECT_EQ(codegen::text::shortest_float("0.000000000001f"), "1.0e-12f");
    EXPECT_EQ(codegen::text::shortest_float("5u"), "5u");
    EXPECT_EQ(codegen::text::shortest_float("0x7fu"), "0x7fu");
    for (const char* text : {"0.100000001490116119384765625", "16777216.0",
                             "340282346638528859811704183484516925440.0", "1.17549435e-38"}) {
        const std::string shorter = codegen::text::shortest_float(text);
        EXPECT_EQ(std::strtof(shorter.c_str(), nullptr), std::strtof(text, nullptr)) << shorter;
    }
}

TEST(Text, ChoicesOfTwoAssignmentsBecomeConditionals) {
    EXPECT_EQ(tidied("float f(float x) { float lq_selected; if (x > 0.0) { lq_selected = g(x); } "
                     "else { lq_selected = 0.0; } float y = lq_selected; return y; }"),
              "float f(float x) {\n    float y = x > 0.0 ? g(x) : 0.0;\n    return y;\n}\n");
}

TEST(Text, NestedChoicesKeepTheirParentheses) {
    EXPECT_EQ(
        tidied("float f(float x) { float lq_selected; float lq_selected_1; if (x > 0.0) { if (x > "
               "1.0) { lq_selected_1 = a; } else { lq_selected_1 = b; } lq_selected = "
               "lq_selected_1; } else { lq_selected = c; } return lq_selected; }"),
        "float f(float x) {\n    return x > 0.0 ? (x > 1.0 ? a : b) : c;\n}\n");
}

TEST(Text, ChoicesUsedTwiceStayVariables) {
    EXPECT_EQ(tidied("float f(float x) { float lq_selected; if (x > 0.0) { lq_selected = x; } else "
                     "{ lq_selected = y; } return lq_selected * lq_selected; }"),
              "float f(float x) {\n    float selected;\n    selected = x > 0.0 ? x : y;\n"
              "    return selected * selected;\n}\n");
}

TEST(Text, AssignmentsOfTheSourceStayStatements) {
    const std::string source =
        "float f(float x) {\n    float y;\n    if (x > 0.0) {\n        y = x;\n    } else {\n"
        "        y = 0.0;\n    }\n    return y;\n}\n";
    EXPECT_EQ(tidied(source), source);
}

TEST(Text, NumberedNamesReturnToTheirOwnInSeparateScopes) {
    EXPECT_EQ(
        tidied("void f() { if (a) { float x = 1.0; g(x); } if (b) { float x_1 = 2.0; g(x_1); } }"),
        "void f() {\n    if (a) {\n        float x = 1.0;\n        g(x);\n    }\n"
        "    if (b) {\n        float x = 2.0;\n        g(x);\n    }\n}\n");
}

TEST(Text, NumberedNamesStayWhereTheNameIsInSight) {
    const std::string nested =
        "void f(float x) {\n    if (a) {\n        float x_1 = x;\n        g(x_1);\n    }\n}\n";
    EXPECT_EQ(tidied(nested), nested);
}

TEST(Text, NamelessStructsAreNamedByTheirType) {
    EXPECT_EQ(tidied("LqFacets f(float a) { LqFacets _12 = { a }; return _12; }", Dialect::hlsl),
              "LqFacets f(float a) {\n    LqFacets result = { a };\n    return result;\n}\n");
    EXPECT_THAT(
        tidied("float f(float a) { LqPlainSurface _12 = { a }; return g(_12); }", Dialect::hlsl),
        testing::HasSubstr("LqPlainSurface plain_surface = { a };"));
}

TEST(Text, ComponentsAreJoined) {
    EXPECT_THAT(tidied("void f(vec3 u) { vec2 a = vec2(u.y, u.z); }"),
                testing::HasSubstr("vec2 a = u.yz;"));
    EXPECT_THAT(tidied("void f(vec3 u) { vec2 a = vec2(u.y, v.z); }"),
                testing::HasSubstr("vec2(u.y, v.z)"));
    EXPECT_THAT(tidied("void f(vec3 u) { vec3 a = vec3(u.y, u.z, 1.0); }"),
                testing::HasSubstr("vec3(u.y, u.z, 1.0)"));
}

TEST(Text, NamelessConstantsAreInlined) {
    EXPECT_THAT(tidied("float f(float x) { float _3 = 2.0 * LQ_PI; return x * _3; }"),
                testing::HasSubstr("    return x * (2.0 * LQ_PI);\n"));
    EXPECT_THAT(tidied("float f(float x) { float _3 = g(x); x = 1.0; return x * _3; }"),
                testing::HasSubstr("float values = g(x);"));
}

TEST(Text, ElseIfIsJoined) {
    EXPECT_EQ(tidied("void f() { if (a) { g(); } else { if (b) { h(); } else { i(); } } }"),
              "void f() {\n    if (a) {\n        g();\n    } else if (b) {\n        h();\n"
              "    } else {\n        i();\n    }\n}\n");
    // Not where something follows the inner choice.
    EXPECT_THAT(tidied("void f() { if (a) { g(); } else { if (b) { h(); } i(); } }"),
                testing::HasSubstr("} else {\n        if (b) {"));
}

TEST(Text, LongLinesBreakAtTheLoosestPlace) {
    const std::string a(40, 'a');
    const std::string b(40, 'b');
    EXPECT_EQ(printed("void f() { return " + a + " * " + a + " + " + b + "; }"),
              "void f() {\n    return " + a + " * " + a + " +\n        " + b + ";\n}\n");
    EXPECT_EQ(printed("void f() { return f(" + a + ", " + a + ", " + b + "); }"),
              "void f() {\n    return f(" + a + ", " + a + ",\n        " + b + ");\n}\n");
}

TEST(Text, BlocksAndDirectivesKeepTheirShape) {
    const std::string source =
        "#version 450\n\nlayout(local_size_x = 64) in;\n\nlayout(binding = 0, std140) uniform A {\n"
        "    uint count;\n    vec4 rows[5];\n} a;\n\nvoid main() {\n    switch (x) {\n"
        "        case 0:\n        {\n            break;\n        }\n        default:\n        {\n"
        "            break;\n        }\n    }\n}\n";
    EXPECT_EQ(printed(source), source);
}

TEST(Text, DeclarationsOfTheSourceAreFound) {
    const auto module = codegen::read_declarations(
        "x.glsl",
        "// The file.\n#ifndef X\n#define X\n\n// A limit.\nconst float LQ_A = 1.5;\n"
        "const int LQ_B = 2;\n\n// A record.\nstruct LqC {\n    float x;\n};\n\n"
        "// A function. More.\nvec3 lq_f(const vec3 wi,\n          in float t[3]) {\n"
        "    return wi;\n}\n#endif\n");
    EXPECT_THAT(module.head, testing::ElementsAre("// The file."));
    ASSERT_EQ(module.declarations.size(), 4u);
    EXPECT_EQ(module.declarations[0].value, "1.5");
    EXPECT_THAT(module.declarations[0].comment, testing::ElementsAre("// A limit."));
    EXPECT_TRUE(module.declarations[1].comment.empty());
    EXPECT_EQ(module.declarations[2].name, "LqC");
    const codegen::Declaration& function = module.declarations[3];
    EXPECT_EQ(function.type, "vec3");
    ASSERT_EQ(function.parameters.size(), 2u);
    EXPECT_EQ(function.parameters[1].name, "t[3]");
    EXPECT_EQ(codegen::first_sentence(function.comment), "A function.");
    EXPECT_EQ(codegen::first_sentence({"// See Walter et al. 2007, Eq. 20."}),
              "See Walter et al. 2007, Eq. 20.");
}

}  // namespace
}  // namespace lacquer::test
