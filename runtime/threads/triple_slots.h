// SPDX-License-Identifier: MIT
#pragma once
#include <atomic>
#include <cstdint>

namespace sinew {

/// Says which of three buffers a writer and a reader may touch, so that neither ever waits: one is being written, one
/// finished, one being read. One writer thread and one reader thread; lock-free.
class TripleSlots {
 public:
  /// Writer: the buffer to write into.
  std::uint8_t writing() const noexcept { return writing_; }

  /// Writer: the buffer is complete; go on with the one that was finished before and never read, or read long ago.
  void publish() noexcept {
    const std::uint8_t given = static_cast<std::uint8_t>(writing_ | kFresh);
    writing_ = middle_.exchange(given, std::memory_order_acq_rel) & kIndex;
  }

  /// Reader: moves on to the newest complete buffer, if there is one that is newer than what it reads.
  void take_newest() noexcept {
    if ((middle_.load(std::memory_order_relaxed) & kFresh) == 0) return;
    reading_ = middle_.exchange(reading_, std::memory_order_acq_rel) & kIndex;
    ever_read_ = true;
  }

  /// Reader: the buffer to read, once ever_read().
  std::uint8_t reading() const noexcept { return reading_; }
  bool ever_read() const noexcept { return ever_read_; }

 private:
  static constexpr std::uint8_t kIndex = 3, kFresh = 4;

  std::uint8_t writing_ = 0;
  alignas(64) std::atomic<std::uint8_t> middle_{1};
  alignas(64) std::uint8_t reading_ = 2;
  bool ever_read_ = false;
};

}  // namespace sinew
