// SPDX-License-Identifier: MIT
#include "importer/tool/annotations_option.h"

#include "importer/clip_annotations.h"
#include "importer/graph/graph_files.h"
#include "importer/tool/messages.h"

namespace sinew::tool {

Option& add_annotations_option(Command& command, std::optional<std::string>& file) {
  return command.option("--annotations", "FILE.json", &file,
                        "Events and curves of clips, by clip names; they replace those that a named clip has");
}

ExitCode annotate_from(const std::optional<std::string>& file, std::span<Animation> animations) {
  if (!file) return ExitCode::done;
  const auto text = read_json_file(*file);
  if (!text) return fail_with(ExitCode::input_at_fault, text.error());
  const std::vector<ImportIssue> issues = annotate_clips(animations, *text);
  for (const ImportIssue& issue : issues) print_error(describe(*file, issue));
  return issues.empty() ? ExitCode::done : ExitCode::input_at_fault;
}

}  // namespace sinew::tool
