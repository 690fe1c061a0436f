// SPDX-License-Identifier: MIT
#include "importer/tool/commands.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "importer/import_gltf.h"
#include "importer/tool/messages.h"
#include "importer/tool/progress_line.h"
#include "importer/visible_text.h"

namespace sinew::tool {
namespace {

struct CheckOptions {
  std::string file;
  bool json = false;
};

std::vector<ImportIssue> broken_rules(const std::string& file) {
  ProgressLine progress;
  ImportOptions options;
  options.thorough = true;
  options.progress = [&](const char* stage, double done) { progress.show(stage, done); };
  auto imported = import_gltf(file, options);
  if (imported) return std::move(imported->warnings);
  ImportError& error = imported.error();
  std::vector<ImportIssue> issues{std::move(error.issue)};
  std::move(error.more_errors.begin(), error.more_errors.end(), std::back_inserter(issues));
  std::move(error.warnings.begin(), error.warnings.end(), std::back_inserter(issues));
  return issues;
}

const char* severity_name(const ImportIssue& issue) { return issue.severity == Severity::error ? "error" : "warning"; }

void print_json(const std::string& file, const std::vector<ImportIssue>& issues, std::size_t errors) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const ImportIssue& issue : issues)
    list.push_back({{"severity", severity_name(issue)},
                    {"rule", issue.rule},
                    {"pointer", issue.json_pointer},
                    {"message", issue.detail}});
  const nlohmann::ordered_json report = {
      {"file", file}, {"errors", errors}, {"warnings", issues.size() - errors}, {"issues", list}};
  fmt::print("{}\n", json_text(report));
}

ExitCode check_file(const CheckOptions& options) {
  const std::vector<ImportIssue> issues = broken_rules(options.file);
  std::size_t errors = 0;
  for (const ImportIssue& issue : issues) errors += issue.severity == Severity::error ? 1 : 0;
  if (options.json) {
    print_json(options.file, issues, errors);
  } else {
    for (const ImportIssue& issue : issues)
      fmt::print("{}: {}{}{}: {}: {}\n", options.file, visible_text(issue.json_pointer),
                 issue.json_pointer.empty() ? "" : ": ", issue.rule, severity_name(issue), visible_text(issue.detail));
    const std::size_t warnings = issues.size() - errors;
    fmt::print("{}: {}, {}\n", options.file, counted(errors, "error"), counted(warnings, "warning"));
  }
  return errors == 0 ? ExitCode::done : ExitCode::input_at_fault;
}

}  // namespace

void add_check(CLI::App& program, ExitCode& outcome) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* command =
      program.add_subcommand("check",
                             "List the rules that a file breaks: place in the document, rule, severity, sentence\n"
                             "Exit status 1 when one of them is an error; a file with only warnings can be loaded.");
  command->add_option("FILE", options->file, "A .gltf or .glb file")->required();
  command->add_flag("--json", options->json,
                    "Print JSON: {file, errors, warnings, issues: [{severity, rule, pointer, message}]}");
  command->callback([options, &outcome] { outcome = check_file(*options); });
}

}  // namespace sinew::tool
