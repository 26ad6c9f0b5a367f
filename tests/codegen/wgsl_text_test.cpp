// How naga's WGSL is tidied: what is moved where, and what must stay because order matters.
#include <gmock/gmock.h>

#include "codegen/emit.h"
#include "codegen/text/print.h"

namespace lacquer::test {
namespace {

std::string tidied(const std::string& naga) {
    return print(codegen::emit_wgsl(naga));
}

TEST(WgslText, LoadsGoWhereTheyAreUsed) {
    EXPECT_EQ(tidied("fn f(x_1: f32) -> f32 {\n    var y: f32;\n\n    y = (x_1 * 2f);\n"
                     "    let _e3 = y;\n    let _e4 = g(_e3);\n    return (_e4 + 1f);\n}\n"),
              "fn f(x: f32) -> f32 {\n    let y = x * 2.0;\n    return g(y) + 1.0;\n}\n");
}

TEST(WgslText, LoadsStayBeforeWhatOverwritesThem) {
    EXPECT_EQ(tidied("fn f(x: f32) -> f32 {\n    var y: f32;\n\n    y = x;\n    let _e3 = y;\n"
                     "    y = 1f;\n    return (_e3 + y);\n}\n"),
              "fn f(x: f32) -> f32 {\n    var y = x;\n    let value = y;\n    y = 1.0;\n"
              "    return value + y;\n}\n");
}

TEST(WgslText, CallsThatReadTheModuleStayBeforeItsWrites) {
    const std::string text = tidied(
        "@group(0) @binding(0) \nvar<storage, read_write> rows: Rows;\n"
        "fn f() {\n    let _e1 = g();\n    rows.first = 2f;\n    rows.second = _e1;\n}\n");
    EXPECT_THAT(text, testing::HasSubstr("let value = g();\n    rows.first = 2.0;"));
}

TEST(WgslText, VariablesSetOnceAreValues) {
    EXPECT_THAT(tidied("fn f() -> f32 {\n    var a: f32;\n    var b: f32;\n\n    a = 1f;\n"
                       "    b = 2f;\n    b = 3f;\n    return (a + b);\n}\n"),
                testing::HasSubstr("    let a = 1.0;\n    var b = 2.0;\n    b = 3.0;\n"));
}

TEST(WgslText, VariablesChangedByMemberAreNoValues) {
    EXPECT_THAT(tidied("fn f() -> A {\n    var a: A;\n\n    a = A(1f);\n    a.x = 2f;\n"
                       "    return a;\n}\n"),
                testing::HasSubstr("    var a = A(1.0);\n    a.x = 2.0;\n"));
}

TEST(WgslText, VariablesThatOutliveATurnStayOutsideTheLoop) {
    const std::string text = tidied(
        "fn f() {\n    var total: f32;\n\n    loop {\n        if c() {\n            total = 1f;\n"
        "        }\n        g(total);\n    }\n}\n");
    EXPECT_THAT(text, testing::HasSubstr("    var total: f32;\n    loop {"));
}

TEST(WgslText, LoopsWithAConditionAreFor) {
    EXPECT_EQ(
        tidied("fn f(n: i32) {\n    var i: i32;\n\n    i = 0i;\n    loop {\n        let _e1 = i;\n"
               "        if (_e1 < n) {\n            let _e2 = i;\n            g(_e2);\n"
               "            continue;\n        } else {\n            break;\n        }\n"
               "        continuing {\n            let _e3 = i;\n            i = (_e3 + 1i);\n"
               "        }\n    }\n}\n"),
        "fn f(n: i32) {\n    for (var i = 0; i < n; i += 1) {\n        g(i);\n    }\n}\n");
}

TEST(WgslText, LoopVariablesUsedLaterStayOutside) {
    EXPECT_THAT(
        tidied("fn f(n: i32) -> i32 {\n    var i: i32;\n\n    i = 0i;\n    loop {\n"
               "        if (i < n) {\n            g();\n            continue;\n        } else {\n"
               "            break;\n        }\n        continuing {\n            i = (i + 1i);\n"
               "        }\n    }\n    return i;\n}\n"),
        testing::HasSubstr("    var i = 0;\n    for (; i < n; i += 1) {"));
}

TEST(WgslText, ChoicesAreAssignedToTheirReceiver) {
    EXPECT_EQ(tidied("fn f(x: f32) -> f32 {\n    var y: f32;\n    var lq_selected: f32;\n\n"
                     "    if (x > 0f) {\n        lq_selected = g(x);\n    } else {\n"
                     "        lq_selected = 0f;\n    }\n    let _e5 = lq_selected;\n    y = _e5;\n"
                     "    return (y * y);\n}\n"),
              "fn f(x: f32) -> f32 {\n    var y: f32;\n    if (x > 0.0) {\n        y = g(x);\n"
              "    } else {\n        y = 0.0;\n    }\n    return y * y;\n}\n");
}

TEST(WgslText, IndicesOfVectorsAreComponentsThoseOfArraysAreNot) {
    EXPECT_EQ(tidied("fn f(v: vec3<f32>, a: array<f32, 3>) -> f32 {\n"
                     "    return (v[2u] + a[2u]);\n}\n"),
              "fn f(v: vec3f, a: array<f32, 3>) -> f32 {\n    return v.z + a[2u];\n}\n");
}

TEST(WgslText, SumsAreNotRegrouped) {
    EXPECT_THAT(tidied("fn f() {\n    var s: f32;\n\n    s = 0f;\n    s = ((s + a) + b);\n"
                       "    s = (s + (a * b));\n    s = (s * (a + b));\n    s = (s * a) * b;\n}\n"),
                testing::HasSubstr("    s = s + a + b;\n    s += a * b;\n    s *= a + b;\n"
                                   "    s = s * a * b;\n"));
}

TEST(WgslText, VectorsAreWholeArguments) {
    EXPECT_THAT(tidied("fn g() -> vec3<f32> {\n    return vec3<f32>(0f, 0f, 0f);\n}\n"
                       "fn f() -> vec4<f32> {\n    let _e1 = g();\n"
                       "    return vec4<f32>(_e1.x, _e1.y, _e1.z, 1f);\n}\n"),
                testing::HasSubstr("return vec4f(g(), 1.0);"));
}

TEST(WgslText, EntryPointsAreOneFunction) {
    EXPECT_EQ(tidied("var<private> id_1: vec3<u32>;\nfn main_1() {\n    let _e1 = id_1[0u];\n"
                     "    if (_e1 > 4u) {\n        return;\n    }\n    g();\n    return;\n}\n"
                     "@compute @workgroup_size(64, 1, 1) \nfn main(@builtin(global_invocation_id) "
                     "id: vec3<u32>) {\n    id_1 = id;\n    main_1();\n}\n"),
              "@compute @workgroup_size(64, 1, 1)\nfn main(@builtin(global_invocation_id) id: "
              "vec3u) {\n    if (id.x > 4u) {\n        return;\n    }\n    g();\n}\n");
}

}  // namespace
}  // namespace lacquer::test
