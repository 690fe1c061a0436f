// SPDX-License-Identifier: MIT
#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "importer/platform/files.h"
#include "importer/platform/program.h"
#include "importer/tool/batch/batch_progress.h"
#include "importer/tool/batch/in_order.h"
#include "importer/tool/commands.h"
#include "importer/tool/files/output.h"
#include "importer/tool/messages.h"
#include "importer/tool/units/emit.h"
#include "importer/tool/units/unit.h"
#include "importer/tool/units/unit_report.h"
#include "importer/tool/units/unit_result.h"
#include "importer/visible_text.h"

namespace sinew::tool {
namespace {

namespace fs = std::filesystem;

struct UnitsOptions {
  std::string input, command, out;
  std::optional<std::string> shard;
  std::uint32_t jobs = 0, shards = 0;
  double shard_s = 300.0;
  bool merge = false, again = false;
  std::string emit;
};

/// Units I, I + N, I + 2N, ... counted from 1.
struct Shard {
  std::size_t index = 1, count = 1;
};

std::optional<Shard> read_shard(const std::string& text) {
  const auto number = [](std::string_view digits) -> std::size_t {
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return error == std::errc() && end == digits.data() + digits.size() ? value : 0;
  };
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) return std::nullopt;
  const Shard shard{number(text.substr(0, slash)), number(text.substr(slash + 1))};
  if (shard.index == 0 || shard.index > shard.count) return std::nullopt;
  return shard;
}

/// The program of a unit's command: `render` is the viewer, all others are commands of this program.
/// in,out  words   loses its first word where that names the program
fs::path program_of(std::vector<std::string>& words) {
  const bool renders = words.front() == "render";
  if (renders) words.erase(words.begin());
  return platform::program_folder() / platform::program_file(renders ? "sinew-viewer" : "sinew");
}

UnitResult run_unit(const Unit& unit) {
  std::vector<std::string> words = unit.words;
  const fs::path program = program_of(words);
  const auto start = std::chrono::steady_clock::now();
  auto ended = platform::run_program(program, words, true);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!ended) return {unit.name, static_cast<int>(ExitCode::machine_lacks), ended.error() + '\n', seconds};
  return {unit.name, ended->status, std::move(ended->output), seconds};
}

bool make_folders(const Unit& unit, const fs::path& out) {
  std::error_code error;
  fs::create_directories(out / "units", error);
  if (!error)
    fs::create_directories((out / "files" / platform::path_of(unit.name).relative_path()).parent_path(), error);
  return !error;
}

std::string line_of(const UnitResult& result, bool is_old) {
  if (result.status == 0) return fmt::format("{}: {}\n", visible_text(result.name), is_old ? "done before" : "done");
  return fmt::format("{}: failed with status {}: {}\n", visible_text(result.name), result.status,
                     visible_text(result.last_line()));
}

/// Runs the files of a shard whose result is not in OUT yet.
ExitCode run_shard(const UnitsOptions& options, const std::vector<Unit>& units, const std::vector<std::string>& command,
                   const Shard& shard) {
  std::vector<const Unit*> own;
  for (std::size_t i = shard.index - 1; i < units.size(); i += shard.count) own.push_back(&units[i]);
  const fs::path out = platform::path_of(options.out);
  const auto work = [&](std::size_t i) -> JobOutcome {
    const Unit& unit = *own[i];
    const std::string id = id_of(unit, command);
    const fs::path file = result_file(out, id.empty() ? "unread" : id);
    if (const auto old = id.empty() ? std::nullopt : read_result(file); old && (old->status == 0 || !options.again))
      return {old->status == 0 ? ExitCode::done : ExitCode::input_at_fault, line_of(*old, true), {}};
    if (!make_folders(unit, out)) return {ExitCode::machine_lacks, {}, options.out + ": folders cannot be made\n"};
    const UnitResult result = run_unit(unit);
    if (!id.empty() && !write_result(file, result))
      return {ExitCode::machine_lacks, {}, platform::text_of(file) + ": cannot be written\n"};
    return {result.status == 0 ? ExitCode::done : ExitCode::input_at_fault, line_of(result, false), {}};
  };
  ExitCode worst = ExitCode::done;
  BatchProgress progress(own.size());
  const auto show = [&](std::size_t i, JobOutcome&& outcome) {
    progress.hide();
    print_result_text(outcome.results);
    if (!outcome.messages.empty()) print_error(outcome.messages.substr(0, outcome.messages.size() - 1));
    worst = std::max(worst, outcome.code);
    progress.show(i + 1);
  };
  run_in_order(own.size(), options.jobs > 0 ? options.jobs : cores_to_use(), work, show);
  progress.hide();
  return worst;
}

/// Writes the three reports of all units.
ExitCode merge(const UnitsOptions& options, const std::vector<Unit>& units, const std::vector<std::string>& command) {
  const fs::path out = platform::path_of(options.out);
  UnitReport report{options.command, {}};
  for (const Unit& unit : units) {
    const std::string id = id_of(unit, command);
    report.rows.push_back({unit.name, id.empty() ? std::nullopt : read_result(result_file(out, id))});
  }
  std::error_code error;
  fs::create_directories(out, error);
  for (const auto& [name, text] :
       {std::pair("report.json", report_json(report)), std::pair("report.csv", report_csv(report)),
        std::pair("report.html", report_html(report))})
    if (const ExitCode code = write_output(out / name, std::as_bytes(std::span(text.data(), text.size())));
        code != ExitCode::done)
      return code;
  print_result("{}, {} failed, {} not run: {}\n", counted(units.size(), "unit"), report.failed(), report.missing(),
               platform::text_of(out / "report.html"));
  return report.failed() + report.missing() == 0 ? ExitCode::done : ExitCode::input_at_fault;
}

/// Number of shards of about `shard_s` seconds, by the units that were measured.
/// err  nothing was measured yet
std::optional<ShardedBatch> sized(const UnitsOptions& options, const std::vector<Unit>& units,
                                  const std::vector<std::string>& command) {
  double seconds = 0.0;
  std::size_t measured = 0;
  for (const Unit& unit : units)
    if (const std::string id = id_of(unit, command); !id.empty())
      if (const auto result = read_result(result_file(platform::path_of(options.out), id))) {
        seconds += result->seconds;
        ++measured;
      }
  if (measured == 0 && options.shards == 0) return std::nullopt;
  const double all_s =
      measured == 0 ? 0.0 : seconds / static_cast<double>(measured) * static_cast<double>(units.size());
  ShardedBatch batch{
      {"sinew", "batch", options.input, "--do", options.command, "-o", options.out}, options.shards, 0.0};
  if (batch.shards == 0)
    batch.shards =
        std::clamp<std::size_t>(static_cast<std::size_t>(std::ceil(all_s / options.shard_s)), 1, units.size());
  batch.seconds = all_s / static_cast<double>(batch.shards);
  return batch;
}

ExitCode emit(const UnitsOptions& options, const std::vector<Unit>& units, const std::vector<std::string>& command) {
  const auto batch = sized(options, units, command);
  if (!batch)
    return fail_with(ExitCode::wrong_usage, "--emit: no unit was measured yet; run a few first, or give --shards");
  const std::string text = options.emit == "slurm"      ? slurm_script(*batch)
                           : options.emit == "parallel" ? parallel_lines(*batch)
                                                        : makefile(*batch);
  return write_output("-", std::as_bytes(std::span(text.data(), text.size())));
}

ExitCode run_units(const UnitsOptions& options) {
  const auto command = split_words(options.command);
  if (!command) return fail_with(ExitCode::wrong_usage, "--do: " + command.error());
  const bool names_input = std::any_of(command->begin(), command->end(),
                                       [](const std::string& word) { return word.find("{in}") != std::string::npos; });
  if (command->empty() || !names_input)
    return fail_with(ExitCode::wrong_usage, "--do: the command does not say where the file stands: {in}");
  const auto shard = options.shard ? read_shard(*options.shard) : Shard{};
  if (!shard) return fail_with(ExitCode::wrong_usage, "--shard: I/N with 1 <= I <= N is wanted, as in 3/8");
  const auto units = list_units(options.input, *command, platform::path_of(options.out));
  if (!units) return fail_with(ExitCode::input_at_fault, units.error());
  if (units->empty()) return fail_with(ExitCode::input_at_fault, options.input + ": names no file");
  if (!options.emit.empty()) return emit(options, *units, *command);
  if (options.merge) return merge(options, *units, *command);
  const ExitCode code = run_shard(options, *units, *command, *shard);
  return options.shard || code == ExitCode::machine_lacks ? code : merge(options, *units, *command);
}

}  // namespace

Command batch_command() {
  auto options = std::make_shared<UnitsOptions>();
  Command command(
      "batch",
      "Run a command on many files, resume, and report\n"
      "Each file is a unit: a process of its own, whose result is written at once to OUT/units, named by the hash of "
      "the command, the file, the files that it names, and goldens that it is compared with. A unit that has a result "
      "is not run again, so a batch that was "
      "killed goes on where it was. At the end there are OUT/report.json, .csv and .html, with failures first in the "
      "page; they are the same however the units were run.\n"
      "\n"
      "Other programs run shards side by side: `--emit slurm`, `parallel` or `make` prints what they need.\n"
      "  sinew batch assets/ --do 'verify {in} goldens/{name}.json' -o night/\n"
      "  sinew batch assets/ --do 'compile {in} -o {out}.sinew --budget 0.1mm' -o night/ --shard 3/8\n"
      "  sinew batch assets/ --do 'render {in} --headless {out}.png' -o night/ --emit slurm");
  command
      .argument("INPUT", &options->input,
                "A folder of models, with its folders, or a text file with the path of a model in each line")
      .required();
  command
      .option("--do", "COMMAND", &options->command,
              "A command of sinew with its options, or `render` with those of the viewer; {in} stands for the file, "
              "{out} for a path in OUT/files without an extension, {name} for the file's name without its extension")
      .required();
  command.option("-o,--output", "OUT", &options->out, "Folder for results, outputs and the report").required();
  command.option("--shard", "I/N", &options->shard, "Run only every N-th unit, from the I-th on; no report");
  command.flag("--merge", options->merge, "Run nothing; write the report of what has been run").excludes("--shard");
  command.flag("--again", options->again, "Also run units again that failed");
  command.option("--jobs", "N", &options->jobs, "Units at a time (default: one for each core)").within(1, 1024);
  command.option("--emit", "KIND", &options->emit, "Print a script that runs all shards: slurm, parallel or make")
      .one_of({"slurm", "parallel", "make"})
      .excludes("--shard")
      .excludes("--merge");
  command.option("--shards", "N", &options->shards, "With --emit: number of shards").within(1, 1e6).needs("--emit");
  command
      .option("--shard-seconds", "S", &options->shard_s,
              "With --emit: as many shards as take about so long each, by the units that were run (default: 300)")
      .within(1, 1e6)
      .needs("--emit");
  command.run = [options] { return run_units(*options); };
  return command;
}

}  // namespace sinew::tool
