// `lacquer export`: the shaders in every language, for engines and other programs.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>

#include "cli/commands.h"
#include "cli/options.h"
#include "codegen/codegen.h"
#include "core/error.h"
#include "core/paths.h"
#include "core/progress.h"

namespace lacquer {

namespace {

constexpr const char* kSummary = "Write the shaders in every language, with a manifest";

constexpr const char* kHelp =
    R"(Writes TARGET/FORM/LEVEL*.EXT and manifest.json below the folder. The form `library` has
functions and structs only, to be pasted into a shader of your own; `kernel` has entry points
over the bindings that the manifest lists. WGSL needs Node.js.

Levels that read tables come with tables/lacquer_tables.rgba32ui: bind it as the storage buffer
`tables` of compute kernels, or upload it as a texture of that format and the manifest's width and
height as `tables` of sphere_view. In the form `library` define
lq_table_texel(index) yourself; the head of the file says how. In Metal it can only read an array
of constants: nothing bound is global there.

The levels stack and stack_symmetric are compiled for stacks of at most --max-layers layers, with
--stack-lobes lobes: 3, of the top interface, of those below it, and of a conductor; or 2, for speed,
the latter two as one with the light of both and its mean width. `albedo` then counts all of that as
the base's. Kernels take 3 + 3 max-layers rows a stack.

Targets: {}.
Forms: kernel, library.
Levels: {}.
Without --target, --form or --level all there are.

Examples:
  lacquer export --all -o shaders
  lacquer export --target hlsl60 --target wgsl --form library -o shaders
  lacquer export --level stack --max-layers 2 --stack-lobes 2 -o shaders)";

std::string help() {
    std::string targets;
    for (const codegen::Target target : codegen::all_targets())
        targets += fmt::format("{}{}", targets.empty() ? "" : ", ", codegen::target_name(target));
    return fmt::format(kHelp, targets, fmt::join(codegen::level_names(), ", "));
}

struct Arguments {
    bool all = false;
    std::vector<std::string> targets, forms, levels;
    codegen::StackChoices stacks;
    std::filesystem::path folder;
    bool json = false;
};

// Throws UsageError where something is chosen for stacks and none is exported.
void require_stacks(const Arguments& arguments) {
    const codegen::StackChoices usual;
    const bool chosen =
        arguments.stacks.max_layers != usual.max_layers || arguments.stacks.lobes != usual.lobes;
    const bool exports_stacks = arguments.levels.empty() ||
                                std::ranges::any_of(arguments.levels, [](const std::string& level) {
                                    return level == "stack" || level == "stack_symmetric";
                                });
    if (chosen && !exports_stacks)
        throw UsageError{
            "--max-layers and --stack-lobes are for the levels stack and stack_symmetric, of which "
            "none is exported"};
}

codegen::Request request_of(const Arguments& arguments) {
    codegen::Request request;
    request.source_root = share_file("shader_src");
    request.tables_folder = share_file("tables");
    for (const std::string& name : arguments.targets)
        request.targets.push_back(codegen::target_from_name(name));
    for (const std::string& name : arguments.forms)
        request.forms.push_back(codegen::form_from_name(name));
    request.levels = arguments.levels;
    request.stacks = arguments.stacks;
    require_stacks(arguments);
    return request;
}

codegen::Package generate(const Arguments& arguments) {
    codegen::Request request = request_of(arguments);
    std::unique_ptr<Progress> progress;
    std::size_t shown = 0;
    request.progress = [&](std::size_t done, std::size_t total) {
        if (!progress) progress = std::make_unique<Progress>("export", total);
        progress->advance(done - shown);
        shown = done;
    };
    return codegen::generate(request);
}

struct Sum {
    std::size_t files = 0;
    std::size_t bytes = 0;
    std::size_t instructions = 0;
};

std::string summary(const codegen::Package& package) {
    std::map<std::pair<codegen::Target, codegen::Form>, Sum> sums;
    for (const codegen::ShaderFile& file : package.files) {
        Sum& sum = sums[{file.target, file.form}];
        ++sum.files;
        sum.bytes += file.contents.size();
        sum.instructions += file.instruction_count;
    }
    std::string table = fmt::format("{:<8} {:<8} {:>6} {:>9} {:>13}\n", "target", "form", "files",
                                    "bytes", "instructions");
    for (const auto& [key, sum] : sums)
        table +=
            fmt::format("{:<8} {:<8} {:>6} {:>9} {:>13}\n", codegen::target_name(key.first),
                        codegen::form_name(key.second), sum.files, sum.bytes, sum.instructions);
    return table;
}

void run(const Arguments& arguments) {
    const codegen::Package package = generate(arguments);
    codegen::write(package, arguments.folder);
    const std::string text = arguments.json ? codegen::manifest(package) : summary(package);
    if (std::fputs(text.c_str(), stdout) < 0 || std::fflush(stdout) != 0)
        throw Error{"writing to the standard output failed"};
    if (!arguments.json)
        fmt::print(stderr, "{} files and manifest.json in '{}'\n",
                   package.files.size() + package.tables.size(), arguments.folder.string());
}

}  // namespace

void add_export_command(CLI::App& app) {
    auto arguments = std::make_shared<Arguments>();
    CLI::App* command = app.add_subcommand("export", kSummary)->footer(help());
    CLI::Option* all = command->add_flag("--all", arguments->all, "Everything there is");
    command->add_option("--target", arguments->targets, "A language; may be repeated")
        ->excludes(all);
    command->add_option("--form", arguments->forms, "kernel or library; may be repeated")
        ->excludes(all);
    command->add_option("--level", arguments->levels, "A part of the library; may be repeated")
        ->excludes(all);
    command->add_option(
        "--max-layers", arguments->stacks.max_layers,
        fmt::format("The most layers of a stack: {} to {}; {} if not given", codegen::kMinLayers,
                    codegen::kMaxLayers, arguments->stacks.max_layers));
    command->add_option(
        "--stack-lobes", arguments->stacks.lobes,
        fmt::format("The lobes of a stack, 2 or 3; {} if not given", arguments->stacks.lobes));
    command->add_option("-o,--output", arguments->folder, "The folder to write to; made if missing")
        ->required();
    command->add_flag("--json", arguments->json, "Print the manifest instead of a table");
    command->callback([arguments] { run(*arguments); });
}

}  // namespace lacquer
