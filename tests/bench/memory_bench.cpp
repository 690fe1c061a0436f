// SPDX-License-Identifier: MIT
#include <cstring>
#include <vector>

#include "tests/bench/measure.h"

namespace sinew::bench {

/// What copying costs on this machine: the floor under every job that reads and writes as many bytes.
void add_memory() {
  for (const auto& [label, bytes] : {std::pair{"32k", 32u << 10}, {"256k", 256u << 10}, {"4M", 4u << 20}, {"64M", 64u << 20}}) {
    benchmark::RegisterBenchmark((std::string("memory/copy/") + label).c_str(), [bytes = bytes](benchmark::State& state) {
      std::vector<char> from(bytes, 1), to(bytes);
      for (auto _ : state) {
        std::memcpy(to.data(), from.data(), bytes);
        benchmark::DoNotOptimize(to.data());
        benchmark::ClobberMemory();
      }
      const auto total = static_cast<double>(state.iterations()) * bytes;
      state.SetBytesProcessed(static_cast<std::int64_t>(total));
      state.counters["per_item"] = benchmark::Counter(total, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    });
  }
}

}  // namespace sinew::bench
