// From a request to every file it asks for.
#include <fmt/format.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <map>
#include <mutex>

#include "codegen/arrange.h"
#include "codegen/codegen.h"
#include "codegen/cost.h"
#include "codegen/emit.h"
#include "codegen/head.h"
#include "codegen/library.h"
#include "codegen/naga.h"
#include "codegen/names.h"
#include "codegen/reflect.h"
#include "codegen/sha256.h"
#include "codegen/table_file.h"
#include "codegen/targets.h"
#include "codegen/text/print.h"
#include "codegen/variants.h"
#include "core/error.h"

namespace lacquer::codegen {

namespace {

// One kernel or library of one level: what to compile, and what its source declares.
struct Variant {
    const Level* level = nullptr;
    Form form = Form::kernel;
    KernelSource source;
    std::string text;  // to compile
    std::string preamble;
    std::vector<SourceModule> modules;
    std::string source_sha256;  // of those
};

// Its modules in SPIR-V: as executed, and with what makes text of it readable.
struct CompiledVariant {
    Words words;
    Words readable_words;
    std::size_t table_reads = 0;
    std::map<std::string, std::size_t> instruction_counts;  // of functions that cost something
};

// What users of a level call: lq_LEVEL_*.
constexpr std::string_view kVerbs[] = {"prepare", "view", "eval",   "eval_cos", "view_eval_cos",
                                       "sample",  "pdf",  "albedo", "profile",  "base_prefiltered"};

std::string hash_of(const SourceTree& tree, const std::vector<SourceModule>& modules) {
    std::string all;
    for (const SourceModule& module : modules) all += tree.text(module.file);
    return sha256(all);
}

Variant kernel_variant(const SourceTree& tree, const Level& level, const std::string& preamble,
                       const KernelSource& source) {
    Variant variant{&level, Form::kernel, source, tree.text(source.file), preamble, {}, {}};
    variant.modules = read_declarations(tree, source.file);
    variant.source_sha256 = hash_of(tree, variant.modules);
    return variant;
}

Variant library_variant(const SourceTree& tree, const Level& level, const std::string& preamble) {
    const std::string source{level.source};
    Variant variant{&level, Form::library, {{}, "library.frag", kLibraryStage}, {}, preamble, {},
                    {}};
    variant.modules = read_declarations(tree, source);
    variant.text = library_entry(source, variant.modules);
    variant.source_sha256 = hash_of(tree, variant.modules);
    return variant;
}

// Of the entry point of a kernel; of the functions that users of a level call.
std::map<std::string, std::size_t> instruction_counts(const SourceTree& tree,
                                                      const Variant& variant, const Words& words) {
    if (variant.form == Form::kernel) return {{"main", optimised_instruction_count(words, "main")}};
    std::map<std::string, std::size_t> counts;
    for (const std::string_view verb : kVerbs) {
        const std::string name = fmt::format("lq_{}_{}", variant.level->name, verb);
        const std::string text =
            function_entry(std::string{variant.level->source}, variant.modules, name);
        if (text.empty()) continue;
        SpirvModule module{
            compile(tree, variant.source.file, text, {variant.source.stage, variant.preamble})};
        cut_signatures(module);
        counts[name] = optimised_instruction_count(module.words(), name);
    }
    return counts;
}

CompiledVariant compile_variant(const SourceTree& tree, const Variant& variant) {
    CompileOptions options{variant.source.stage, variant.preamble};
    SpirvModule executed{compile(tree, variant.source.file, variant.text, options)};
    cut_signatures(executed);
    mark_read_only_buffers(executed);
    options.named_constants = true;
    SpirvModule readable{compile(tree, variant.source.file, variant.text, options)};
    cut_signatures(readable);
    mark_read_only_buffers(readable);
    release_constants(readable);
    inline_struct_constants(readable);
    name_temporaries(readable);
    const bool reads_tables = defines_function(executed, kTableAccess);
    CompiledVariant compiled{
        executed.words(), readable.words(), reads_tables ? table_reads(*variant.level) : 0, {}};
    compiled.instruction_counts = instruction_counts(tree, variant, compiled.words);
    return compiled;
}

// Translated and tidied; of WGSL, naga's text is given.
text::Statements emit(const CompiledVariant& compiled, Target target, const std::string& naga) {
    switch (target) {
        case Target::hlsl50:
        case Target::hlsl60:
            return emit_hlsl(compiled.readable_words, target);
        case Target::msl:
            return emit_msl(compiled.readable_words);
        case Target::wgsl:
            return emit_wgsl(naga);
        default:
            return emit_glsl(compiled.readable_words, target);
    }
}

std::filesystem::path file_path(const Variant& variant, Target target) {
    const TargetEntry& entry = target_entry(target);
    if (variant.form == Form::library)
        return fmt::format("{}/library/{}.{}", entry.name, variant.level->name, entry.extension);
    const std::string_view infix = variant.source.stage == Stage::vertex     ? ".vert"
                                   : variant.source.stage == Stage::fragment ? ".frag"
                                                                             : "";
    return fmt::format("{}/kernel/{}_{}{}.{}", entry.name, variant.level->name,
                       variant.source.kernel, infix, entry.extension);
}

void fill_text(ShaderFile& file, const Variant& variant, const CompiledVariant& compiled,
               const std::string& naga, const StackChoices& stacks) {
    const text::Dialect dialect = dialect_of(file.target);
    text::Statements statements = emit(compiled, file.target, naga);
    if (file.form == Form::library) {
        statements = arrange_library(std::move(statements), variant.modules, dialect);
        file.functions = public_functions(statements, variant.modules, dialect);
        for (Function& function : file.functions)
            if (const auto count = compiled.instruction_counts.find(function.name);
                count != compiled.instruction_counts.end())
                function.instruction_count = count->second;
    } else {
        statements = arrange_kernel(std::move(statements), variant.modules, dialect);
    }
    const std::string body = print(statements);
    // Only a version may stand above the first comment in every dialect of GLSL.
    const std::size_t version = body.starts_with("#version") ? body.find('\n') + 1 : 0;
    file.contents = body.substr(0, version) +
                    file_head(file, *variant.level, stacks, variant.source_sha256) +
                    body.substr(version == 0 ? 0 : body.find_first_not_of('\n', version));
}

ShaderFile make_file(const Variant& variant, const CompiledVariant& compiled, Target target,
                     const std::string& naga, const StackChoices& stacks) {
    ShaderFile file;
    file.path = file_path(variant, target);
    file.target = target;
    file.form = variant.form;
    file.level = variant.level->name;
    file.kernel = variant.source.kernel;
    file.instruction_count =
        instruction_count(SpirvModule{compiled.words}, variant.form == Form::kernel);
    file.table_reads = compiled.table_reads;
    if (file.form == Form::kernel) {
        const Reflection reflection = reflect(compiled.words);
        file.entry_points = reflection.entry_points;
        file.bindings = reflection.bindings;
        for (EntryPoint& point : file.entry_points)
            point.instruction_count = compiled.instruction_counts.at(point.name);
        if (target == Target::msl)
            for (EntryPoint& point : file.entry_points) point.name = kMslEntryPoint;
    }
    if (target == Target::spirv)
        file.contents = {reinterpret_cast<const char*>(compiled.words.data()),
                         compiled.words.size() * sizeof(Words::value_type)};
    else
        fill_text(file, variant, compiled, naga, stacks);
    file.sha256 = sha256(file.contents);
    return file;
}

template <typename T>
bool chosen(const std::vector<T>& choice, const T& value) {
    return choice.empty() || std::ranges::find(choice, value) != choice.end();
}

// A vertex shader goes with the fragment shader of its name.
bool has_kernel(const SourceTree& tree, const Level& level, const KernelSource& source) {
    return shades_surfaces(tree, source) || source.stage == Stage::vertex ||
           level.name == all_levels().front().name;
}

std::vector<Variant> chosen_variants(const SourceTree& tree, const Request& request) {
    for (const std::string& name : request.levels) level_from_name(name);
    std::vector<Variant> variants;
    for (const Level& level : all_levels()) {
        if (!chosen(request.levels, std::string{level.name})) continue;
        const std::string preamble = level_preamble(level, request.stacks);
        if (chosen(request.forms, Form::kernel))
            for (const KernelSource& source : all_kernels(tree))
                if (has_kernel(tree, level, source))
                    variants.push_back(kernel_variant(tree, level, preamble, source));
        if (chosen(request.forms, Form::library))
            variants.push_back(library_variant(tree, level, preamble));
    }
    return variants;
}

// Throws UsageError where what was asked for exists in no language.
void require_any(std::size_t file_count) {
    if (file_count > 0) return;
    throw UsageError{fmt::format(
        "no variant is of that target and form: {} has no library form, {} no compute kernels",
        target_name(Target::spirv), target_name(Target::essl300))};
}

std::vector<Target> chosen_targets(const Request& request, const Variant& variant) {
    std::vector<Target> targets;
    for (const Target target : all_targets()) {
        const bool possible = variant.form == Form::library
                                  ? can_express_library(target)
                                  : can_express(target, variant.source.stage);
        if (possible && chosen(request.targets, target)) targets.push_back(target);
    }
    return targets;
}

// A file to be made: of variants[variant] in `target`.
struct Job {
    std::size_t variant;
    Target target;
};

std::vector<Job> chosen_jobs(const Request& request, const std::vector<Variant>& variants) {
    std::vector<Job> jobs;
    for (std::size_t i = 0; i < variants.size(); ++i)
        for (const Target target : chosen_targets(request, variants[i]))
            jobs.push_back({i, target});
    return jobs;
}

// Reports progress from any thread.
class Counter {
 public:
    using Report = std::function<void(std::size_t done, std::size_t total)>;

    Counter(const Report& report, std::size_t total) : report_{report}, total_{total} {
        if (report_) report_(0, total_);
    }

    void advance() {
        const std::lock_guard lock{mutex_};
        ++done_;
        if (report_) report_(done_, total_);
    }

 private:
    const Report& report_;
    std::size_t total_;
    std::size_t done_ = 0;
    std::mutex mutex_;
};

void require_naga(const Request& request) {
    if (!chosen(request.targets, Target::wgsl)) return;
    const WgslAvailability naga = wgsl_availability();
    if (!naga.usable) throw Error{naga.reason};
}

// naga's texts of all variants, in one process.
std::vector<std::string> naga_texts(const std::vector<Variant>& variants,
                                    const std::vector<CompiledVariant>& compiled) {
    std::vector<NagaJob> jobs;
    for (std::size_t i = 0; i < variants.size(); ++i)
        jobs.push_back({variants[i].source.file, compiled[i].readable_words});
    return translate_to_wgsl(jobs);
}

}  // namespace

Package generate(const Request& request) {
    require_valid(request.stacks);
    require_naga(request);
    const SourceTree tree{request.source_root};
    const std::vector<Variant> variants = chosen_variants(tree, request);
    const std::vector<Job> jobs = chosen_jobs(request, variants);
    require_any(jobs.size());
    Counter counter{request.progress, variants.size() + jobs.size()};
    std::vector<CompiledVariant> compiled(variants.size());
    tbb::parallel_for(std::size_t{0}, variants.size(), [&](std::size_t i) {
        compiled[i] = compile_variant(tree, variants[i]);
        counter.advance();
    });
    std::vector<std::string> naga(variants.size());
    if (chosen(request.targets, Target::wgsl)) naga = naga_texts(variants, compiled);
    Package package{tree.hash(), request.stacks, std::vector<ShaderFile>(jobs.size()), {}};
    tbb::parallel_for(std::size_t{0}, jobs.size(), [&](std::size_t i) {
        const auto [variant, target] = jobs[i];
        package.files[i] =
            make_file(variants[variant], compiled[variant], target, naga[variant], request.stacks);
        counter.advance();
    });
    const bool tables = std::ranges::any_of(
        package.files, [](const ShaderFile& file) { return file.table_reads > 0; });
    if (tables && !request.tables_folder.empty())
        package.tables = {table_file(request.tables_folder)};
    return package;
}

}  // namespace lacquer::codegen
