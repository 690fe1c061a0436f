// SPDX-License-Identifier: MIT
#pragma once
#include <atomic>
#include <cstdint>

namespace sinew {

/// Says which of three frame buffers the writer and the reader may touch, so that neither waits. One buffer is being
/// written, one is finished, one is being read. One writer at a time and one reader; lock-free.
///
/// With two buffers one of the three places is empty. Once the writer has published a buffer, it has none to write into
/// until the reader takes that buffer and gives back the one before.
class TripleSlots {
 public:
  /// in   buffer_count  3, or 2 (see above)
  explicit TripleSlots(std::uint8_t buffer_count = 3) noexcept : absent_(buffer_count) {}

  /// True if prepare_to_write() will find a buffer; always true for three buffers. The reader may call it while no
  /// writer is active.
  bool can_write() const noexcept {
    return writing_ != absent_ || (middle_.load(std::memory_order_relaxed) & kFresh) == 0;
  }

  /// Writer, before it writes: if it has no buffer, takes the one that the reader has given back.
  void prepare_to_write() noexcept {
    if (writing_ == absent_) writing_ = middle_.exchange(absent_, std::memory_order_acq_rel) & kIndex;
  }

  /// Writer: the buffer to write into.
  std::uint8_t writing() const noexcept { return writing_; }

  /// Writer: hands over its complete buffer. In exchange it gets the one that was published before and never read, or
  /// the one that the reader has given back. With two buffers it may get none.
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

  std::uint8_t absent_;  // index that means "no buffer": 2 for two buffers; 3, which never occurs, for three
  std::uint8_t writing_ = 0;
  alignas(64) std::atomic<std::uint8_t> middle_{1};
  alignas(64) std::uint8_t reading_ = 2;
  bool ever_read_ = false;
};

}  // namespace sinew
