// The files of shader_src, read once: their texts, their includes, their hash.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace lacquer::codegen {

class SourceTree {
 public:
    // Reads every shader below `root`. Throws Error where there is none.
    explicit SourceTree(std::filesystem::path root);

    // The text of a file named relative to the root with '/'; nullptr where there is none.
    const std::string* find(const std::string& name) const;

    // The same; throws Error naming the file.
    const std::string& text(const std::string& name) const;

    // `name` and all that it includes, each file after those that it includes itself: the order in
    // which a compiler meets their declarations. Throws Error naming file and line of an include
    // that leads nowhere.
    std::vector<std::string> closure(const std::string& name) const;

    // The file that `including` means by #include "included".
    static std::string resolve(const std::string& including, const std::string& included);

    // The path to show in messages.
    std::string shown(const std::string& name) const { return (root_ / name).string(); }

    // SHA-256 over all names and texts.
    const std::string& hash() const { return hash_; }

    const std::map<std::string, std::string>& files() const { return files_; }

 private:
    std::filesystem::path root_;
    std::map<std::string, std::string> files_;
    std::string hash_;
};

}  // namespace lacquer::codegen
