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

/// Reads frames of a geometry cache for a FrameWindow, on the calling thread or on its own thread.
class CacheReader {
 public:
  enum class Reads : std::uint8_t {
    blocking,  ///< a read returns when the data is there: pictures are never late
    on_thread  ///< a read returns at once and finishes on the reader's thread
  };

  /// in   file  must outlive this. If it cannot be opened, all reads fail.
  ///      most_reads  largest number of pending reads: the frames of the window
  CacheReader(const CacheFile& file, Reads reads, std::size_t most_reads);
  ~CacheReader();
  CacheReader(const CacheReader&) = delete;
  CacheReader& operator=(const CacheReader&) = delete;

  FrameReader reader() noexcept;  ///< valid while this object exists

  /// Finishes all pending reads and ends the thread. Afterwards the window may be destroyed; later reads fail.
  void stop() noexcept;

  std::uint64_t bytes_read() const noexcept { return bytes_read_.load(std::memory_order_relaxed); }

 private:
  struct Request {
    std::uint64_t offset = 0;
    std::span<std::byte> into;
    FrameRead* read = nullptr;
  };
  ReadOutcome submit(const Request& request) noexcept;
  bool read(const Request& request) noexcept;
  void work() noexcept;

  const CacheFile& file_;
  int descriptor_ = -1;
  std::atomic<std::uint64_t> bytes_read_{0};
  std::mutex mutex_;
  std::condition_variable arrived_;
  std::vector<Request> requests_;  // ring buffer
  std::size_t first_ = 0, count_ = 0;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace sinew::viewer
