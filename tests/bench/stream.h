// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <vector>

namespace sinew::bench {

/// Memory traffic of a job without its arithmetic: reads and writes as many bytes. Output larger than the caches
/// bypasses them. No job with this traffic can be faster.
class StreamTraffic {
 public:
  StreamTraffic(std::size_t bytes_in, std::size_t bytes_out);
  void run();
  std::size_t bytes() const { return (in_.size() + out_.size()) * sizeof(Line); }

 private:
  struct alignas(64) Line {
    float floats[16] = {};
  };
  std::vector<Line> in_, out_;
};

}  // namespace sinew::bench
