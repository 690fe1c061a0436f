// SPDX-License-Identifier: MIT
#include "importer/tool/commands.h"

#include <iterator>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "importer/tool/assets/asset_rules.h"
#include "importer/tool/batch/run_batch.h"
#include "importer/tool/check/check_report.h"
#include "importer/tool/check/rules_table.h"
#include "importer/tool/check/severity_choice.h"
#include "importer/tool/load_file.h"
#include "importer/tool/messages.h"

namespace sinew::tool {
namespace {

struct CheckOptions {
  BatchOptions files;
  bool all = false, strict = false, rules = false;
  std::vector<std::string> severities;
};

/// Most reports of one rule that --all lists. So many fit into memory for any file.
constexpr std::size_t kListedWithAll = 100'000;

std::vector<ImportIssue> broken_rules(const std::string& file, bool all) {
  if (auto of_assets = broken_asset_rules(file)) return *std::move(of_assets);
  ImportOptions options;
  options.thorough = options.collect_all_errors = true;
  if (all) options.max_listed_per_rule = kListedWithAll;
  auto imported = import_with_progress(file, options);
  if (imported) return std::move(imported->warnings);
  ImportError& error = imported.error();
  std::vector<ImportIssue> issues{std::move(error.issue)};
  std::move(error.more_errors.begin(), error.more_errors.end(), std::back_inserter(issues));
  std::move(error.warnings.begin(), error.warnings.end(), std::back_inserter(issues));
  return issues;
}

/// One command with its options.
class FileCheck {
 public:
  FileCheck(const CheckOptions& options, SeverityChoice severities)
      : options_(options), severities_(std::move(severities)) {}

  ExitCode run(const std::string& file, bool many) {
    std::vector<ImportIssue> issues = broken_rules(file, options_.all);
    severities_.apply(issues);
    const CheckReport report(file, std::move(issues));
    totals_.add(report);
    if (options_.files.json)
      print_json(report.json(), many);
    else
      print_result_text(many && !options_.all ? report.summary() : report.text(options_.all));
    const std::size_t faults = report.count(Severity::error) + (options_.strict ? report.count(Severity::warning) : 0);
    return faults == 0 ? ExitCode::done : ExitCode::input_at_fault;
  }

  std::string totals() const { return totals_.text(); }

 private:
  const CheckOptions& options_;
  SeverityChoice severities_;
  CheckTotals totals_;
};

ExitCode check_files(const CheckOptions& options) {
  if (options.rules) {
    print_result_text(options.files.json ? rules_json() : rules_text());
    return ExitCode::done;
  }
  if (options.files.inputs.empty())
    return fail_with(ExitCode::wrong_usage, "FILE is required (see `sinew check --help`)");
  auto severities = SeverityChoice::parse(options.severities);
  if (!severities) return fail_with(ExitCode::wrong_usage, severities.error());
  FileCheck check(options, *std::move(severities));
  return run_batch(options.files, {[&](const Input& file, bool many) { return check.run(file.path, many); },
                                   [&] { return check.totals(); },
                                   {},
                                   FileKind::models_and_assets});
}

}  // namespace

Command check_command() {
  auto options = std::make_shared<CheckOptions>();
  Command command(
      "check",
      "List the rules that files break: place in the document, rule, severity, sentence\n"
      "A rule that is broken at many places has one line, with their number and the first of them. Several files have "
      "one line each.\n"
      "\n"
      "Exit status 1 when a file has an error; a file with only warnings can be loaded. Infos name what is odd or "
      "unused.");
  add_batch_options(command, options->files,
                    ".gltf, .glb or .sinew files, and folders of them; - is the standard input");
  command.flag("--json", options->files.json,
               "Print JSON: {file, errors, warnings, infos, issues: [{severity, rule, pointer, message, cases}]};\n"
               "of several files one document a line. The last issue of a rule stands for cases not listed");
  command.flag("--all", options->all, "List every place that breaks a rule");
  command.flag("--strict", options->strict, "Warnings fail, too");
  command
      .option("--severity", "RULE=SEVERITY[,...]", &options->severities,
              "What a rule counts as here: error, warning, info or off. It changes no file and no loading")
      .list();
  command.flag("--rules", options->rules, "List all rules with their severities, and check nothing");
  command.run = [options] { return check_files(*options); };
  return command;
}

}  // namespace sinew::tool
