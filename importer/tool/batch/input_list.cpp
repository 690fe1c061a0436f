// SPDX-License-Identifier: MIT
#include "importer/tool/batch/input_list.h"
#include "importer/platform/files.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <system_error>
#include <utility>

namespace sinew::tool {
namespace {

namespace fs = std::filesystem;

const char* file_of(FileKind kind) {
  if (kind == FileKind::geometry_caches) return "geometry cache (.sgeo)";
  if (kind == FileKind::other_formats) return ".bvh, .fbx or .dae file";
  return kind == FileKind::models ? ".glb, .gltf or .vrm file" : ".glb, .gltf, .vrm or .sinew file";
}

/// Walks a folder that the user named.
class FolderWalk {
 public:
  FolderWalk(bool recursive, FileKind kind, std::vector<Input>& out) : recursive_(recursive), kind_(kind), out_(out) {}

  void run(const fs::path& folder) {
    const std::size_t before = out_.size();
    enter(folder, {});
    if (out_.size() > before) return;
    const bool may_be_below = has_folders_ && !recursive_;
    remark(
        folder,
        std::string("holds no ") + file_of(kind_) + (may_be_below ? " itself; --recursive looks into its folders" : ""),
        true);
  }

 private:
  void remark(const fs::path& folder, std::string text, bool fault) {
    out_.push_back({platform::text_of(folder), {}, std::move(text), fault, {}});
  }

  void enter(const fs::path& folder, const fs::path& below) {
    std::error_code error;
    const fs::path real = fs::canonical(folder, error);
    if (!error && !entered_.insert(real).second)
      return remark(folder, "leads to a folder that was looked into already; it is left out", false);
    std::set<fs::path> names;
    fs::directory_iterator entries(folder, error);  // sets `error` anew
    for (; !error && entries != fs::directory_iterator(); entries.increment(error))
      names.insert(entries->path().filename());
    if (error) remark(folder, "cannot be read: " + error.message(), true);
    for (const fs::path& name : names) visit(folder / name, below / name);
  }

  void visit(const fs::path& path, const fs::path& below) {
    std::error_code error;
    if (fs::is_directory(path, error)) {
      has_folders_ = true;
      if (recursive_) enter(path, below);
    } else if (is_named_as(kind_, platform::text_of(path))) {
      out_.push_back({platform::text_of(path), platform::text_of(below), {}, false, {}});
    }
  }

  bool recursive_;
  FileKind kind_;
  bool has_folders_ = false;
  std::vector<Input>& out_;
  std::set<fs::path> entered_;
};

}  // namespace

bool is_named_as(FileKind kind, const std::string& file) {
  std::string extension = platform::text_of(platform::path_of(file).extension());
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (kind == FileKind::geometry_caches) return extension == ".sgeo";
  if (kind == FileKind::other_formats) return extension == ".bvh" || extension == ".fbx" || extension == ".dae";
  if (kind == FileKind::models_and_assets && extension == ".sinew") return true;
  return extension == ".glb" || extension == ".gltf" || extension == ".vrm";
}

InputList list_inputs(const std::vector<std::string>& arguments, bool recursive, FileKind kind) {
  InputList list;
  list.many = arguments.size() > 1;
  for (const std::string& argument : arguments) {
    std::error_code error;
    if (argument != kStandardInput && fs::is_directory(platform::path_of(argument), error)) {
      list.many = true;
      FolderWalk(recursive, kind, list.inputs).run(platform::path_of(argument));
    } else {
      list.inputs.push_back({argument, platform::text_of(platform::path_of(argument).filename()), {}, false, {}});
    }
  }
  return list;
}

}  // namespace sinew::tool
