// Compilers for generated text, and the packages that tests look at.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "codegen/codegen.h"

namespace lacquer::test {

// All that the project's shader source yields, generated once.
const codegen::Package& everything();

// Its files of a target, or of a target and form; never none.
std::vector<codegen::ShaderFile> files_of(codegen::Target target);
std::vector<codegen::ShaderFile> files_of(codegen::Target target, codegen::Form form);

// The project's shader source with the files of tests/codegen/source: kernel `constructs`.
codegen::Package with_constructs();

// Every target whose files are text.
std::vector<codegen::Target> text_targets();

// What glslang's GLSL front end says against `text`; empty where it compiles. Stages are named as
// in the manifest.
std::string glsl_complaint(const std::string& text, std::string_view stage);

// The same of its HLSL front end; the entry point is `main`.
std::string hlsl_complaint(const std::string& text, std::string_view stage);

// The function that users of a library that reads tables supply, empty for other files.
std::string stand_ins(const codegen::ShaderFile& file);

// What makes `file` a shader of its own: functions get an empty main around them.
std::string as_shader(const codegen::ShaderFile& file);

// What is said against a text file of any language; empty where it compiles.
std::string complaint(const codegen::ShaderFile& file);

// The code of a text without its comments.
std::string without_comments(const std::string& text);

}  // namespace lacquer::test
