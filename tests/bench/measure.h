// SPDX-License-Identifier: MIT
#pragma once
#include <benchmark/benchmark.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace sinew::bench {

/// Properties of a case besides its time.
struct Facts {
  double error =
      std::numeric_limits<double>::quiet_NaN();   ///< largest, against double precision: radians, metres, or relative
  std::size_t bytes = 0;                          ///< least number of bytes that one run reads and writes
  bool wall_time = false;                         ///< measure wall time instead of the calling thread's CPU time
  std::function<void(benchmark::State&)> report;  ///< adds counters after the runs; may be empty
};

/// One benchmark, named `job/implementation/case`. `work()` is one run over `item_count` joints or vertices.
struct Case {
  std::string name;
  std::size_t item_count;
  std::function<void()> work;
  Facts facts;
};

/// All cases in the order in which they were added.
std::vector<Case>& cases();

template <class Work>
void add(const std::string& name, std::size_t item_count, Work work, Facts facts = {}) {
  cases().push_back({name, item_count, std::move(work), facts});
}

/// Registers all cases with Google Benchmark. Its column `per_item` is the time of one item, in seconds with SI prefix.
void register_cases();

/// 1, 2, 4, ... up to the number of cores of the machine; always at least 1 and 2.
std::vector<std::size_t> thread_counts();

/// Counts instructions under callgrind: runs each of our own cases of at most 100,000 items once, on each target that
/// callgrind supports. Callgrind dumps each count under the name `target case item_count`.
/// err  false: not under valgrind
bool count_instructions();

/// Each benchmark file has one of these functions; main() calls them all.
void add_import();
void add_setup();
void add_asset_files();
void add_memory();
void add_sample();
void add_blend();
void add_mirrors();
void add_springs();
void add_local_to_model();
void add_instances();
void add_crowd();
void add_correctives();
void add_palettes();
void add_morph();
void add_flat_normals();
void add_skin(std::size_t most_vertices);
void add_model_skin();
void add_frame(std::size_t most_vertices);
void add_geometry_cache();
void add_job_thread();
void add_ik();

}  // namespace sinew::bench
