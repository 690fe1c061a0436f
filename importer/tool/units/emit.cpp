// SPDX-License-Identifier: MIT
#include "importer/tool/units/emit.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/core.h>

namespace sinew::tool {
namespace {

/// A word for a POSIX shell.
std::string shell_word(std::string_view word) {
  constexpr std::string_view kPlain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-+=./:,@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string_view::npos) return std::string(word);
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? "'\\''" : std::string(1, c);
  return out + "'";
}

std::string line_of(const ShardedBatch& batch) {
  std::string line;
  for (const std::string& word : batch.words) line += (line.empty() ? "" : " ") + shell_word(word);
  return line;
}

}  // namespace

std::string slurm_script(const ShardedBatch& batch) {
  // Three times the expected time, at least ten minutes: a limit that is reached ends the shard, and it resumes.
  const auto minutes = static_cast<int>(std::ceil(std::max(10.0, 3.0 * batch.seconds / 60.0)));
  return fmt::format(
      "#!/bin/sh\n"
      "# Submit with `sbatch`; when all have ended: {0} --merge\n"
      "#SBATCH --job-name=sinew\n"
      "#SBATCH --array=1-{1}\n"
      "#SBATCH --time={2}\n"
      "#SBATCH --requeue\n"
      "exec {0} --shard \"$SLURM_ARRAY_TASK_ID/{1}\"\n",
      line_of(batch), batch.shards, minutes);
}

std::string parallel_lines(const ShardedBatch& batch) {
  std::string out;
  for (std::size_t s = 1; s <= batch.shards; ++s)
    out += fmt::format("{} --shard {}/{}\n", line_of(batch), s, batch.shards);
  return out;
}

std::string makefile(const ShardedBatch& batch) {
  std::string line;
  for (const char c : line_of(batch)) line += c == '$' ? "$$" : std::string(1, c);
  std::string shards;
  for (std::size_t s = 1; s <= batch.shards; ++s) shards += fmt::format(" shard-{}", s);
  std::string out = fmt::format("report:{}\n\t{} --merge\n.PHONY: report{}\n", shards, line, shards);
  for (std::size_t s = 1; s <= batch.shards; ++s)
    out += fmt::format("shard-{0}:\n\t-{1} --shard {0}/{2}\n", s, line, batch.shards);
  return out;
}

}  // namespace sinew::tool
