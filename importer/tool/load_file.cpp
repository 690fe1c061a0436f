// SPDX-License-Identifier: MIT
#include "importer/tool/load_file.h"

#include <utility>

#include "importer/tool/messages.h"
#include "importer/tool/progress_line.h"

namespace sinew::tool {

std::optional<ImportedFile> load_file(const std::string& file, ImportOptions options) {
  ProgressLine progress;
  options.progress = [&](const char* stage, double done) { progress.show(stage, done); };
  auto imported = import_gltf(file, options);
  progress.wipe();
  for (const ImportIssue& warning : imported ? imported->warnings : imported.error().warnings) say_issue(file, warning);
  if (imported) return std::move(*imported);
  say_issue(file, imported.error().issue);
  for (const ImportIssue& error : imported.error().more_errors) say_issue(file, error);
  return std::nullopt;
}

}  // namespace sinew::tool
