// SPDX-License-Identifier: MIT
#include "importer/tool/convert/output_files.h"

#include <fmt/format.h>

#include "importer/write/replace_file.h"

namespace sinew::tool {
namespace fs = std::filesystem;

std::vector<fs::path> OutputFiles::all() const {
  return buffer.empty() ? std::vector{file} : std::vector{file, buffer};
}

OutputFiles output_files(const std::string& in, const std::string& out, std::string& why) {
  OutputFiles files{out, {}};
  if (files.file.extension() == ".gltf") files.buffer = fs::path(files.file).replace_extension(".bin");
  const fs::path folder = files.file.has_parent_path() ? files.file.parent_path() : fs::path(".");
  std::error_code error;
  if (files.file.extension() != ".glb" && files.buffer.empty())
    why = "OUT must end in .glb or .gltf, which says what is written";
  else if (fs::equivalent(in, out, error))
    why = "OUT is the file that is read; it is left as it is";
  else if (!fs::is_directory(folder, error))
    why = fmt::format("there is no folder {}", folder.string());
  return files;
}

std::string overwritten_input(const std::string& in, const ImportedFile& model, const OutputFiles& outputs) {
  std::vector<fs::path> inputs{in};
  for (const std::string& name : files_read_by(model)) inputs.push_back(fs::path(in).parent_path() / name);
  std::error_code error;
  for (const fs::path& output : outputs.all())
    for (const fs::path& input : inputs)
      if (fs::equivalent(input, output, error)) return output.string();
  return {};
}

std::optional<std::string> write_files(const OutputFiles& outputs, const RewrittenFile& model) {
  std::vector<write::FileContent> files;
  if (!model.buffer.empty()) files.push_back({outputs.buffer, model.buffer});
  files.push_back({outputs.file, model.file});
  return write::replace_files(files);
}

}  // namespace sinew::tool
