// SPDX-License-Identifier: MIT
#pragma once
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

#include "runtime/geometry_cache/frame_window.h"
#include "viewer/app/cache/cache_file.h"

namespace sinew::viewer {

/// Reads the frames of a geometry cache for a FrameWindow: where the window asks, or on a thread of its own.
class CacheReader {
 public:
  enum class Reads : std::uint8_t {
    at_once,  ///< a frame is there when it is asked for: pictures are never late
    beside    ///< on a thread: whoever asks goes on
  };

  /// in   file  must outlive this;   most_reads  that wait at one time: the frames of the window
  /// A file that cannot be opened now gives reads that fail.
  CacheReader(const CacheFile& file, Reads reads, std::size_t most_reads);
  ~CacheReader();
  CacheReader(const CacheReader&) = delete;
  CacheReader& operator=(const CacheReader&) = delete;

  FrameReader reader() noexcept;  ///< valid as long as this

  /// Finishes all reads and ends the thread: after it, the window may end. Later reads fail.
  void stop() noexcept;

  std::uint64_t bytes_read() const noexcept { return bytes_read_.load(std::memory_order_relaxed); }

 private:
  struct Asked {
    std::uint64_t offset = 0;
    std::span<std::byte> into;
    FrameRead* read = nullptr;
  };
  ReadOutcome ask(const Asked& asked) noexcept;
  bool read(const Asked& asked) noexcept;
  void work() noexcept;

  const CacheFile& file_;
  int descriptor_ = -1;
  std::atomic<std::uint64_t> bytes_read_{0};
  std::mutex mutex_;
  std::condition_variable came_;
  std::vector<Asked> asked_;  // a ring
  std::size_t first_ = 0, count_ = 0;
  bool ends_ = false;
  std::thread thread_;
};

}  // namespace sinew::viewer
