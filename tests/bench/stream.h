// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <vector>

namespace sinew::bench {

/// Reads and writes the same number of bytes as a job, but computes almost nothing: a lower bound for the job's time.
/// If the output is larger than 8 MiB, its stores bypass the caches.
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
