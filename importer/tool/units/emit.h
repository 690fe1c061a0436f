// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace sinew::tool {

/// A batch that another program runs in shards.
struct ShardedBatch {
  std::vector<std::string> words;  ///< "sinew batch ..." without shard and merge
  std::size_t shards = 1;
  double seconds = 0.0;  ///< expected for one shard; 0 = nobody knows
};

/// Scripts that run all shards, then merge: a job array of Slurm, lines for GNU parallel, or a makefile.
std::string slurm_script(const ShardedBatch& batch);
std::string parallel_lines(const ShardedBatch& batch);
std::string makefile(const ShardedBatch& batch);

}  // namespace sinew::tool
