// SPDX-License-Identifier: MIT
#include "importer/tool/files/model_output.h"

#include <string_view>

#include <fmt/core.h>

#include "importer/platform/files.h"
#include "importer/tool/files/output.h"
#include "importer/tool/messages.h"
#include "importer/write/replace_file.h"

namespace sinew::tool {
namespace fs = std::filesystem;
namespace {

ExitCode write_files(const ModelOutput& output, const RewrittenFile& model) {
  if (model.buffer.empty()) return write_output(output.file, model.file);
  const write::FileContent files[] = {{output.buffer, model.buffer}, {output.file, model.file}};
  const auto error = write::replace_files(files);
  if (!error) return ExitCode::done;
  return fail_with(ExitCode::machine_lacks, platform::text_of(output.file),
                   {Severity::error, "write-file", "", *error});
}

}  // namespace

tl::expected<ModelOutput, std::string> model_output(const std::string& out) {
  ModelOutput output{platform::path_of(out), {}};
  if (is_stream(output.file)) return output;
  if (output.file.extension() == ".gltf") output.buffer = fs::path(output.file).replace_extension(".bin");
  if (output.file.extension() != ".glb" && output.buffer.empty())
    return tl::unexpected(out + ": OUT must end in .glb or .gltf, which says what is written");
  return output;
}

std::optional<std::string> find_output_error(const ModelOutput& output, std::span<const fs::path> inputs) {
  auto error = find_output_error(output.file, inputs);
  if (!error && !output.buffer.empty()) error = find_output_error(output.buffer, inputs);
  return error;
}

void add_drop_option(Command& command, std::vector<std::string>& drop, const char* about) {
  command.option("--drop", "NAME[,NAME...]", &drop, std::string(about) + ": names as they are listed, or all").list();
}

tl::expected<std::size_t, ExitCode> write_model(const ImportedFile& model, const std::string& in,
                                                RewriteOptions changes, const std::vector<std::string>& drop,
                                                const ModelOutput& output) {
  changes.drop.insert(drop.begin(), drop.end());
  changes.buffer_uri = platform::text_of(output.buffer.filename());
  const auto written = rewrite_gltf(model, changes);
  if (!written) return tl::unexpected(print_rewrite_error(in, written.error()));
  return write_rewritten(*written, in, output);
}

tl::expected<std::size_t, ExitCode> write_rewritten(const RewrittenFile& model, const std::string& in,
                                                    const ModelOutput& output) {
  for (const ImportIssue& dropped : model.drops) print_issue(in, dropped);
  if (const ExitCode code = write_files(output, model); code != ExitCode::done) return tl::unexpected(code);
  return model.file.size() + model.buffer.size();
}

ExitCode print_rewrite_error(const std::string& in, const ImportError& error) {
  print_issue(in, error.issue);
  for (const ImportIssue& more : error.more_errors) print_issue(in, more);
  if (error.issue.rule == "not-carried")
    print_error(
        fmt::format("{}: {} cannot be carried; --drop NAME[,NAME...] writes the file without, --drop all without any",
                    in, counted(1 + error.more_errors.size(), "thing")));
  return ExitCode::input_at_fault;
}

}  // namespace sinew::tool
