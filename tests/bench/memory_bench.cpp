// SPDX-License-Identifier: MIT
#include <cstring>
#include <vector>

#include "tests/bench/measure.h"

namespace sinew::bench {

/// Time of copying memory on this machine: no job that reads and writes as many bytes can be faster.
void add_memory() {
  struct Buffers {
    std::vector<char> from, to;
    explicit Buffers(std::size_t bytes) : from(bytes, 1), to(bytes) {}
  };
  for (const auto& [label, bytes] : {std::pair{"32k", std::size_t{32} << 10},
                                     {"256k", std::size_t{256} << 10},
                                     {"4M", std::size_t{4} << 20},
                                     {"64M", std::size_t{64} << 20}}) {
    const auto buffers = std::make_shared<Buffers>(bytes);
    add(std::string("memory/copy/") + label, bytes,
        [buffers] {
          std::memcpy(buffers->to.data(), buffers->from.data(), buffers->from.size());
          benchmark::DoNotOptimize(buffers->to.data());
        },
        {Facts{}.error, 2 * bytes});
  }
}

}  // namespace sinew::bench
