// SPDX-License-Identifier: MIT
#include "importer/tool/batch/run_batch.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <new>
#include <sstream>
#include <utility>

#include <fmt/core.h>

#include "importer/platform/program.h"
#include "importer/tool/batch/batch_progress.h"
#include "importer/tool/batch/captured_output.h"
#include "importer/tool/batch/in_order.h"
#include "importer/tool/batch/output_folder.h"
#include "importer/tool/json.h"
#include "importer/tool/messages.h"
#include "importer/visible_text.h"

namespace sinew::tool {
namespace {

constexpr std::uint32_t kMostJobs = 256;

ExitCode worse(ExitCode a, ExitCode b) {
  constexpr std::array kRising = {ExitCode::done, ExitCode::input_at_fault, ExitCode::cannot_read,
                                  ExitCode::machine_lacks, ExitCode::wrong_usage};
  return std::find(kRising.begin(), kRising.end(), a) > std::find(kRising.begin(), kRising.end(), b) ? a : b;
}

/// The line of a file for which the command gave no result.
std::string failure_line(const std::string& path, const std::string& messages, bool json) {
  if (!json) return visible_text(path) + ": failed\n";
  Json lines = Json::array();
  std::istringstream stream(messages);
  for (std::string line; std::getline(stream, line);)
    lines.push_back(line.starts_with("sinew: ") ? line.substr(7) : line);
  return json_line({{"file", path}, {"failed", true}, {"messages", lines}});
}

/// Runs the command on one file. An exception of one file does not end the work on the others.
JobOutcome outcome_of(const Input& input, const BatchOptions& options, const BatchWork& work) {
  CapturedOutput output;
  JobOutcome out;
  try {
    if (input.remark.empty()) {
      out.code = work.run(input, true);
    } else {
      out.code = input.fault ? work.bad_folder : ExitCode::done;
      print_error(input.path + ": " + input.remark);
    }
  } catch (const std::bad_alloc&) {
    out.code = fail_with(ExitCode::machine_lacks, input.path + ": not enough memory");
  } catch (const std::exception& error) {
    out.code = fail_with(ExitCode::machine_lacks, input.path + ": " + error.what());
  }
  if (out.code != ExitCode::done && output.results.empty() && input.remark.empty())
    output.results = failure_line(input.path, output.messages, options.json);
  out.results = std::move(output.results);
  out.messages = std::move(output.messages);
  return out;
}

/// Shows outcomes as they arrive, and counts them.
class Report {
 public:
  explicit Report(const InputList& list) : list_(list), progress_(list.inputs.size()) {}

  void show(std::size_t index, const JobOutcome& outcome) {
    if (results_on_terminal_ || !outcome.messages.empty()) progress_.hide();
    if (!outcome.messages.empty()) std::fflush(stdout);  // both streams may be one terminal
    std::fwrite(outcome.messages.data(), 1, outcome.messages.size(), stderr);
    std::fwrite(outcome.results.data(), 1, outcome.results.size(), stdout);
    progress_.show(index + 1);
    code_ = worse(code_, outcome.code);
    if (list_.inputs[index].remark.empty()) ++(outcome.code == ExitCode::done ? done_ : failed_);
  }

  /// "1000 files: 950 done, 50 failed; TOTALS"
  std::string summary(const std::string& totals) {
    progress_.hide();
    return fmt::format("{}: {} done, {} failed{}{}", counted(done_ + failed_, "file"), done_, failed_,
                       totals.empty() ? "" : "; ", totals);
  }

  ExitCode code() const { return code_; }

 private:
  const InputList& list_;
  BatchProgress progress_;
  const bool results_on_terminal_ = platform::is_terminal(platform::kStandardOutput);
  ExitCode code_ = ExitCode::done;
  std::size_t done_ = 0, failed_ = 0;
};

/// Sets the output path of each file, or says why there is none.
/// err   what is wrong, as a sentence for the user
tl::expected<void, std::string> prepare_outputs(const BatchOutput& output, InputList& list) {
  if (output.folder.empty()) return tl::unexpected(std::string("several files need a folder to write to: -o FOLDER"));
  if (output.folder == kStandardInput)
    return tl::unexpected(std::string("-: several files need a folder to write to, not the standard output"));
  return name_outputs(list, output.folder, output.extension);
}

}  // namespace

Option& add_batch_options(Command& command, BatchOptions& options, const char* about, const char* name) {
  command.flag("--recursive", options.recursive, "Also look into the folders of a folder that is given");
  command
      .option("--jobs", "N", &options.jobs,
              "Files to work on at a time, which changes nothing that is printed (default: one for each core)")
      .within(1, kMostJobs);
  return command.argument(name, &options.inputs, about);
}

ExitCode run_batch(const BatchOptions& options, const BatchWork& work) {
  if (std::count(options.inputs.begin(), options.inputs.end(), kStandardInput) > 1)
    return fail_with(ExitCode::wrong_usage, "-: the standard input can be read once");
  InputList list = list_inputs(options.inputs, options.recursive, work.kind);
  if (!list.many) return work.run(list.inputs.front(), false);
  if (work.output)
    if (const auto prepared = prepare_outputs(*work.output, list); !prepared)
      return fail_with(ExitCode::wrong_usage, prepared.error());
  Report report(list);
  run_in_order(
      list.inputs.size(), options.jobs > 0 ? options.jobs : cores_to_use(),
      [&](std::size_t i) { return outcome_of(list.inputs[i], options, work); },
      [&](std::size_t i, JobOutcome&& outcome) { report.show(i, outcome); });
  const std::string summary = report.summary(work.totals ? work.totals() : std::string());
  options.json ? print_error(summary) : print_result("{}\n", summary);
  return report.code();
}

}  // namespace sinew::tool
