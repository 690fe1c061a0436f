// SPDX-License-Identifier: MIT
#include "importer/tool/files/output_files.h"

#include <fmt/format.h>

#include "importer/tool/messages.h"
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

ExitCode write_files(const OutputFiles& outputs, const RewrittenFile& model) {
  std::vector<write::FileContent> files;
  if (!model.buffer.empty()) files.push_back({outputs.buffer, model.buffer});
  files.push_back({outputs.file, model.file});
  const auto fault = write::replace_files(files);
  if (!fault) return ExitCode::done;
  return fail_with(ExitCode::machine_lacks, outputs.file.string(), {Severity::error, "write-file", "", *fault});
}

ExitCode refuse_rewrite(const std::string& in, const ImportError& error) {
  say_issue(in, error.issue);
  for (const ImportIssue& more : error.more_errors) say_issue(in, more);
  const std::size_t count = 1 + error.more_errors.size();
  if (error.issue.rule == "not-carried")
    say_error(
        fmt::format("{}: {} cannot be carried; --drop NAME[,NAME...] writes the file without, --drop all without any",
                    in, counted(count, "thing")));
  return ExitCode::input_at_fault;
}

}  // namespace sinew::tool
