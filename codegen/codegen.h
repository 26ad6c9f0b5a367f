// From the one shader source to every language.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lacquer::codegen {

enum class Target { spirv, glsl450, essl310, essl300, hlsl50, hlsl60, msl, wgsl };

// `kernel`: entry points over the bindings of shader_src/kernels. `library`: functions and structs
// only, nothing bound, to be pasted into an engine.
enum class Form { kernel, library };

std::string_view target_name(Target target);  // as on the command line and in paths
std::string_view form_name(Form form);
std::span<const Target> all_targets();

std::vector<std::string_view> level_names();

// Throw UsageError listing the names there are.
Target target_from_name(std::string_view name);
Form form_from_name(std::string_view name);

// What stacks are compiled for, in levels that shade them.
struct StackChoices {
    int max_layers = 8;  // LQ_MAX_LAYERS
    int lobes = 3;       // LQ_STACK_LOBES
};

// WGSL grants a function 8 KiB of variables, of which following light through n layers takes
// 224 n + 48 bytes besides half a KiB.
inline constexpr int kMinLayers = 1, kMaxLayers = 32;
inline constexpr int kMinLobes = 2, kMaxLobes = 3;

struct Binding {
    std::string name;
    unsigned set = 0, binding = 0;
    std::string kind;  // "uniform", "storage_read", "storage_read_write", "texture", "sampler"
};

// Instruction counts of entry points and functions are those of SPIR-V after `spirv-opt -O`, with
// all calls inlined.
struct EntryPoint {
    std::string name;   // as it stands in the file
    std::string stage;  // "compute", "vertex", "fragment"
    unsigned workgroup_size[3] = {0, 0, 0};
    std::size_t instruction_count = 0;
};

struct Function {
    std::string name;
    std::string signature;                         // in the file's own language, one line
    std::string summary;                           // first sentence of its documentation
    std::optional<std::size_t> instruction_count;  // of what users of the level call
};

// One generated file.
struct ShaderFile {
    std::filesystem::path path;  // relative: TARGET/FORM/LEVEL_KERNEL.EXT or TARGET/FORM/LEVEL.EXT
    Target target;
    Form form;
    std::string level;     // "plain"
    std::string kernel;    // "eval", ..., or "sphere_view" for graphics; empty in library form
    std::string contents;  // text, or the words of SPIR-V as bytes
    std::vector<EntryPoint> entry_points;
    std::vector<Function> functions;
    std::vector<Binding> bindings;
    std::size_t instruction_count = 0;  // in functions of the SPIR-V it was translated from
    std::size_t table_reads = 0;        // texels that preparing one surface reads at most
    std::string sha256;
};

// The packed tables (shader_src/tables/texels.glsl) for a buffer or, row after row, for a texture;
// the texels behind the last are 0. Numbers are little-endian.
struct TableFile {
    std::filesystem::path path;  // relative: tables/lacquer_tables.FORMAT
    std::string format = "rgba32ui";
    std::size_t texel_count = 0;
    std::size_t width = 0, height = 0;
    std::string contents;
    std::string sha256;
};

struct Request {
    std::filesystem::path source_root;  // shader_src
    // Where the baked tables are, for levels that read them; empty: no table files.
    std::filesystem::path tables_folder;
    std::vector<Target> targets;      // empty: all
    std::vector<Form> forms;          // empty: both
    std::vector<std::string> levels;  // empty: all
    StackChoices stacks;
    std::function<void(std::size_t done, std::size_t total)> progress;
};

// What one request yields.
struct Package {
    std::string source_sha256;  // of everything below shader_src
    StackChoices stacks;
    std::vector<ShaderFile> files;
    std::vector<TableFile> tables;
};

// Whether WGSL can be written here; otherwise the reason and what to do about it.
struct WgslAvailability {
    bool usable = false;
    std::string reason;
};
WgslAvailability wgsl_availability();

// Generates everything asked for; the same request gives the same bytes. Throws UsageError for an
// unknown level, for choices out of range and where nothing is of the target and form asked for,
// Error with file, line and the compiler's message where a source does not compile, and Error with
// the reason where WGSL is asked for and not available.
Package generate(const Request& request);

// The manifest of a package as JSON text; its schema is manifest.schema.json.
std::string manifest(const Package& package);

// Writes the files and `manifest.json` below `folder`, which is made where it is missing; a file
// appears whole or not at all. Throws Error where the folder cannot be written.
void write(const Package& package, const std::filesystem::path& folder);

}  // namespace lacquer::codegen
