// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

namespace sinew::tool {

/// The argument that stands for the standard input.
inline constexpr const char* kStandardInput = "-";

/// One entry of the list of inputs: a file, or instead of a file a remark about a folder.
struct Input {
  std::string path;   ///< the path that is opened, and shown in messages
  std::string below;  ///< path relative to the folder that was given, or the name of a file that was given; outputs are
                      ///< named by it
  std::string remark;  ///< not empty = no file; a sentence about the folder `path`
  bool fault = false;  ///< for a remark: files may be missing, so the command fails
  std::string output;  ///< with several files: where the result of this file is written (output_folder.h)
};

struct InputList {
  std::vector<Input> inputs;
  bool many = false;  ///< several arguments, or a folder: one line a file, and a summary
};

/// The files that a folder stands for: .glb, .gltf and .vrm; also .sinew; only .sgeo; or .bvh, .fbx and .dae.
enum class FileKind { models, models_and_assets, geometry_caches, other_formats };

/// True if the name of a file has an extension of this kind, in upper or lower case.
bool is_named_as(FileKind kind, const std::string& file);

/// Finds the files that arguments name. A folder stands for its files of a kind, sorted by name; with `recursive` also
/// for those in its folders. A folder is entered once, so that loops of symbolic links end. Folders that cannot be
/// read, that hold no such file, or that links lead to again are remarks.
/// in    arguments   files, folders and "-"; files need not exist
InputList list_inputs(const std::vector<std::string>& arguments, bool recursive, FileKind kind = FileKind::models);

}  // namespace sinew::tool
