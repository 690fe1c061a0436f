// SPDX-License-Identifier: MIT
#include "importer/tool/load_file.h"

#include <utility>
#include <vector>

#include "importer/tool/batch/read_input.h"
#include "importer/tool/messages.h"
#include "importer/tool/progress_line.h"

namespace sinew::tool {

void print_import_error(const std::string& file, const ImportError& error) {
  std::vector<ImportIssue> errors{error.issue};
  errors.insert(errors.end(), error.more_errors.begin(), error.more_errors.end());
  print_issues(file, error.warnings);
  print_issues(file, errors);
}

ImportResult<ImportedFile> import_with_progress(const std::string& file, ImportOptions options) {
  ProgressLine progress;
  options.progress = [&](const char* stage, double done) { progress.show(stage, done); };
  return read_input(file, options);
}

std::optional<ImportedFile> load_file(const std::string& file, const ImportOptions& options) {
  auto imported = import_with_progress(file, options);
  if (!imported) {
    print_import_error(file, imported.error());
    return std::nullopt;
  }
  print_issues(file, imported->warnings);
  return std::move(*imported);
}

}  // namespace sinew::tool
