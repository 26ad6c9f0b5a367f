// From a request to every file it asks for.
#include <fmt/format.h>

#include <algorithm>

#include "codegen/codegen.h"
#include "codegen/emit.h"
#include "codegen/naga.h"
#include "codegen/names.h"
#include "codegen/reflect.h"
#include "codegen/sha256.h"
#include "codegen/targets.h"
#include "codegen/variants.h"
#include "core/error.h"

namespace lacquer::codegen {

namespace {

// One shader, compiled twice: as it is executed, and with what makes its text readable.
struct Module {
    const Level* level;
    KernelSource source;
    Words words;
    Words readable_words;
};

Module compile_module(const SourceTree& tree, const Level& level, const KernelSource& source) {
    Module module{&level, source, {}, {}};
    CompileOptions options{source.stage, level.define};
    const std::string& text = tree.text(source.file);
    SpirvModule executed{compile(tree, source.file, text, options)};
    cut_signatures(executed);
    mark_read_only_buffers(executed);
    module.words = executed.words();
    options.named_constants = true;
    SpirvModule readable{compile(tree, source.file, text, options)};
    cut_signatures(readable);
    mark_read_only_buffers(readable);
    release_constants(readable);
    inline_struct_constants(readable);
    name_temporaries(readable);
    module.readable_words = readable.words();
    return module;
}

std::string bytes_of(const Words& words) {
    return {reinterpret_cast<const char*>(words.data()), words.size() * sizeof(Words::value_type)};
}

std::string emit(const Module& module, Target target) {
    switch (target) {
        case Target::spirv:
            return bytes_of(module.words);
        case Target::glsl450:
        case Target::essl310:
        case Target::essl300:
            return emit_glsl(module.readable_words, target);
        case Target::hlsl50:
        case Target::hlsl60:
            return emit_hlsl(module.readable_words, target);
        case Target::msl:
            return emit_msl(module.readable_words);
        case Target::wgsl:
            break;  // translated all at once
    }
    return {};
}

std::filesystem::path file_path(const Module& module, Target target) {
    const TargetEntry& entry = target_entry(target);
    const std::string_view infix = module.source.stage == Stage::vertex     ? ".vert"
                                   : module.source.stage == Stage::fragment ? ".frag"
                                                                            : "";
    return fmt::format("{}/kernel/{}_{}{}.{}", entry.name, module.level->name, module.source.kernel,
                       infix, entry.extension);
}

ShaderFile kernel_file(const Module& module, Target target) {
    ShaderFile file;
    file.path = file_path(module, target);
    file.target = target;
    file.form = Form::kernel;
    file.level = module.level->name;
    file.kernel = module.source.kernel;
    file.contents = emit(module, target);
    const Reflection reflection = reflect(module.words);
    file.entry_points = reflection.entry_points;
    if (target == Target::msl)
        for (EntryPoint& point : file.entry_points) point.name = kMslEntryPoint;
    file.bindings = reflection.bindings;
    file.instruction_count = instruction_count(SpirvModule{module.words});
    return file;
}

template <typename T>
bool chosen(const std::vector<T>& choice, const T& value) {
    return choice.empty() || std::ranges::find(choice, value) != choice.end();
}

std::vector<const Level*> chosen_levels(const Request& request) {
    for (const std::string& name : request.levels) level_from_name(name);
    std::vector<const Level*> levels;
    for (const Level& level : all_levels())
        if (chosen(request.levels, std::string{level.name})) levels.push_back(&level);
    return levels;
}

void require_naga(const Request& request) {
    if (!chosen(request.targets, Target::wgsl)) return;
    const WgslAvailability naga = wgsl_availability();
    if (!naga.usable) throw Error{naga.reason};
}

}  // namespace

Package generate(const Request& request) {
    require_naga(request);
    const SourceTree tree{request.source_root};
    Package package{tree.hash(), {}};
    std::vector<ShaderFile>& files = package.files;
    std::vector<NagaJob> naga_jobs;
    for (const Level* level : chosen_levels(request)) {
        for (const KernelSource& source : all_kernels(tree)) {
            if (!chosen(request.forms, Form::kernel)) break;
            const Module module = compile_module(tree, *level, source);
            for (const Target target : all_targets()) {
                if (!chosen(request.targets, target) || !can_express(target, source.stage))
                    continue;
                files.push_back(kernel_file(module, target));
                if (target == Target::wgsl)
                    naga_jobs.push_back({files.back().path.string(), module.readable_words});
            }
        }
    }
    const std::vector<std::string> wgsl = translate_to_wgsl(naga_jobs);
    auto next_wgsl = wgsl.begin();
    for (ShaderFile& file : files) {
        if (file.target == Target::wgsl) file.contents = *next_wgsl++;
        file.sha256 = sha256(file.contents);
    }
    return package;
}

}  // namespace lacquer::codegen
