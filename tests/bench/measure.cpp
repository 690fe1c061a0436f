// SPDX-License-Identifier: MIT
#include "tests/bench/measure.h"

#include <valgrind/callgrind.h>

#include <cmath>
#include <cstdint>
#include <thread>

#include "tests/bench/targets.h"

namespace sinew::bench {
namespace {

/// True for our own cases whose instruction count is reproducible. Cases with several threads are not.
bool is_counted(const Case& c) {
  const auto says = [&](const char* part) { return c.name.find(part) != std::string::npos; };
  const bool own = says("/sinew/") || says("/tiles/") || says("/packed/") || says("/unpacked/");
  const bool threaded = says("threads") && !says("/1threads");
  return own && !threaded && c.item_count <= 100'000 && !c.name.starts_with("import/");
}

void count(const std::string& target, const Case& c) {
  c.work();  // uncounted warm-up: chooses the instruction set, loads pages
  const std::string label = target + " " + c.name + " " + std::to_string(c.item_count);
  CALLGRIND_START_INSTRUMENTATION;
  CALLGRIND_ZERO_STATS;
  c.work();
  CALLGRIND_DUMP_STATS_AT(label.c_str());
  CALLGRIND_STOP_INSTRUMENTATION;
}

}  // namespace

std::vector<Case>& cases() {
  static std::vector<Case> all;
  return all;
}

std::vector<std::size_t> thread_counts() {
  std::vector<std::size_t> counts = {1, 2};
  const std::size_t most = std::thread::hardware_concurrency();
  while (2 * counts.back() <= most) counts.push_back(2 * counts.back());
  if (counts.back() < most) counts.push_back(most);
  return counts;
}

void register_cases() {
  for (const Case& c : cases()) {
    auto* const registered = benchmark::RegisterBenchmark(c.name.c_str(), [&c](benchmark::State& state) {
      for (auto _ : state) {
        c.work();
        benchmark::ClobberMemory();
      }
      const auto runs = static_cast<double>(state.iterations());
      const double items = runs * static_cast<double>(c.item_count);
      state.SetItemsProcessed(static_cast<std::int64_t>(items));
      if (c.facts.bytes > 0)
        state.SetBytesProcessed(static_cast<std::int64_t>(runs * static_cast<double>(c.facts.bytes)));
      state.counters["per_item"] = benchmark::Counter(items, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
      if (!std::isnan(c.facts.error)) state.counters["error"] = c.facts.error;
      if (c.facts.report) c.facts.report(state);
    });
    if (c.facts.wall_time) registered->UseRealTime();
  }
}

bool count_instructions() {
  if (RUNNING_ON_VALGRIND == 0) return false;
  for (const std::string& target : target_names()) {
    choose_target(target);
    for (const Case& c : cases())
      if (is_counted(c)) count(target, c);
  }
  return true;
}

}  // namespace sinew::bench
