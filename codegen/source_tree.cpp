#include "codegen/source_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>
#include <sstream>

#include "codegen/sha256.h"
#include "core/error.h"
#include "core/file.h"

namespace lacquer::codegen {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kShaderExtensions[] = {".glsl", ".comp", ".vert", ".frag"};

// The file named by a line `#include "..."`, or nothing.
std::string included_file(std::string_view line) {
    constexpr std::string_view kDirective = "#include \"";
    if (!line.starts_with(kDirective)) return {};
    const std::size_t end = line.find('"', kDirective.size());
    if (end == std::string_view::npos) return {};
    return std::string{line.substr(kDirective.size(), end - kDirective.size())};
}

}  // namespace

SourceTree::SourceTree(fs::path root) : root_{std::move(root)} {
    if (!fs::is_directory(root_))
        throw Error{fmt::format("the shader source folder '{}' is missing", root_.string())};
    for (const auto& entry : fs::recursive_directory_iterator{root_}) {
        const std::string extension = entry.path().extension().string();
        if (std::ranges::find(kShaderExtensions, extension) == std::end(kShaderExtensions))
            continue;
        files_[fs::relative(entry.path(), root_).generic_string()] = read_file(entry.path());
    }
    if (files_.empty())
        throw Error{fmt::format("the folder '{}' holds no shader source", root_.string())};
    std::string all;
    for (const auto& [name, content] : files_)
        all += fmt::format("{}\n{}\n", name, sha256(content));
    hash_ = sha256(all);
}

const std::string* SourceTree::find(const std::string& name) const {
    const auto found = files_.find(name);
    return found == files_.end() ? nullptr : &found->second;
}

const std::string& SourceTree::text(const std::string& name) const {
    const std::string* found = find(name);
    if (found == nullptr) throw Error{fmt::format("the file '{}' is missing", shown(name))};
    return *found;
}

std::string SourceTree::resolve(const std::string& including, const std::string& included) {
    return (fs::path{including}.parent_path() / included).lexically_normal().generic_string();
}

std::vector<std::string> SourceTree::closure(const std::string& name) const {
    std::vector<std::string> order;
    std::set<std::string> seen;
    const std::function<void(const std::string&)> visit = [&](const std::string& file) {
        if (!seen.insert(file).second) return;
        std::istringstream lines{text(file)};
        std::string line;
        for (int number = 1; std::getline(lines, line); ++number) {
            const std::string included = included_file(line);
            if (included.empty()) continue;
            const std::string target = resolve(file, included);
            if (find(target) == nullptr)
                throw Error{fmt::format("{}:{}: the included file '{}' is missing", shown(file),
                                        number, included)};
            visit(target);
        }
        order.push_back(file);
    };
    visit(name);
    return order;
}

}  // namespace lacquer::codegen
