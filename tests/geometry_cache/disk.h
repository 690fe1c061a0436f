// SPDX-License-Identifier: MIT
#pragma once
#include <cstring>
#include <mutex>
#include <span>
#include <vector>

#include "runtime/geometry_cache/frame_window.h"

namespace sinew::test {

/// A FrameReader for a file in memory. Reads finish at once, or when `deliver` is called. Thread-safe.
struct Disk {
  struct Waiting {
    std::uint64_t offset;
    std::span<std::byte> into;
    FrameRead* read;
  };
  std::vector<std::byte> file;
  bool at_once = true;
  int failures = 0;  // number of following reads that fail
  std::vector<Waiting> waiting = {};
  std::size_t reads = 0;
  std::mutex mutex = {};

  FrameReader reader() {
    return {[](void* disk, std::uint64_t offset, std::span<std::byte> into, FrameRead& read) noexcept {
              return static_cast<Disk*>(disk)->start({offset, into, &read});
            },
            this};
  }
  ReadOutcome start(const Waiting& read) {
    const std::lock_guard lock(mutex);
    ++reads;
    if (failures > 0) {
      --failures;
      return ReadOutcome::failed;
    }
    if (at_once) {
      copy(read);
      return ReadOutcome::done;
    }
    waiting.push_back(read);
    return ReadOutcome::pending;
  }
  void copy(const Waiting& read) const { std::memcpy(read.into.data(), file.data() + read.offset, read.into.size()); }
  void deliver(std::size_t count) {
    const std::lock_guard lock(mutex);
    for (std::size_t k = 0; k < count && !waiting.empty(); ++k) {
      copy(waiting.front());
      waiting.front().read->finish(true);
      waiting.erase(waiting.begin());
    }
  }
};

}  // namespace sinew::test
