// SPDX-License-Identifier: MIT
#pragma once
#include <benchmark/benchmark.h>

#include <cstddef>
#include <memory>
#include <string>
#include <utility>

namespace sinew::bench {

/// Registers `job/implementation/case`. `work()` is one run over `item_count` joints or vertices; the column `per_item` is
/// the time of one of them, in seconds with an SI prefix.
template <class Work>
void add(const std::string& name, std::size_t item_count, Work work) {
  benchmark::RegisterBenchmark(name.c_str(), [item_count, work](benchmark::State& state) mutable {
    for (auto _ : state) {
      work();
      benchmark::ClobberMemory();
    }
    const auto items = static_cast<double>(state.iterations()) * static_cast<double>(item_count);
    state.SetItemsProcessed(static_cast<std::int64_t>(items));
    state.counters["per_item"] = benchmark::Counter(items, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  });
}

/// Each file of benchmarks has one such function; main calls them all.
void add_import();
void add_memory();
void add_sample();
void add_blend();
void add_local_to_model();
void add_morph();
void add_skin();
void add_frame();

}  // namespace sinew::bench
