// SPDX-License-Identifier: MIT
#include "importer/tool/convert/output_files.h"

#include "importer/write/replace_file.h"

namespace sinew::tool {
namespace fs = std::filesystem;

std::vector<fs::path> OutputFiles::all() const {
  return buffer.empty() ? std::vector{file} : std::vector{file, buffer};
}

std::optional<OutputFiles> output_files(const std::string& out) {
  OutputFiles files{out, {}};
  if (files.file.extension() == ".gltf") files.buffer = fs::path(files.file).replace_extension(".bin");
  if (files.file.extension() != ".glb" && files.buffer.empty()) return std::nullopt;
  return files;
}

std::optional<std::string> write_files(const OutputFiles& outputs, const RewrittenFile& model) {
  std::vector<write::FileContent> files;
  if (!model.buffer.empty()) files.push_back({outputs.buffer, model.buffer});
  files.push_back({outputs.file, model.file});
  return write::replace_files(files);
}

}  // namespace sinew::tool
