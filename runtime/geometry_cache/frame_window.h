// SPDX-License-Identifier: MIT
#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "runtime/base/api.h"
#include "runtime/geometry_cache/geometry_decoder.h"

namespace sinew {

/// A read that was requested from the engine and has not finished yet.
class FrameRead {
 public:
  /// Call once per read, from any thread. `ok` = the bytes have arrived; otherwise the window asks again when it needs
  /// them.
  void finish(bool ok) noexcept { state_.store(ok ? State::ready : State::empty, std::memory_order_release); }

 private:
  friend class FrameWindow;
  enum class State : std::uint8_t { empty, reading, ready };
  std::atomic<State> state_{State::empty};
  std::uint32_t frame_ = kNone;
  std::span<std::byte> room_;
};

enum class ReadOutcome : std::uint8_t {
  done,     ///< the bytes have arrived
  pending,  ///< the engine will call FrameRead::finish
  failed,   ///< the window asks again when it needs the frame
};

/// How the engine reads a file. Several caches may share one reader if `context` or the FrameRead tells their reads
/// apart.
struct SINEW_API FrameReader {
  /// Reads `into.size()` bytes of the file from `offset` on. May return before they have arrived
  /// (ReadOutcome::pending).
  ReadOutcome (*read)(void* context, std::uint64_t offset, std::span<std::byte> into,
                      FrameRead& read) noexcept = nullptr;
  void* context = nullptr;
};

/// A sliding window over the frames of a file that is not in memory. It holds the next frames in play order; its memory
/// does not depend on the length of the file.
///
///     window.prefetch(decoder.next_for(frame));   // requests missing frames among the next ones
///     decoder.decode(frame, window);              // not_loaded: the decoder holds the newest loaded frame
class SINEW_API FrameWindow {
 public:
  /// The cache must outlive this. Every read must have finished before this is destroyed (pending_reads).
  /// in   frames  1 or more
  FrameWindow(const GeometryCache& cache, FrameReader reader, std::uint32_t frames);

  /// Requests the missing frames of the window, starting at `next`. After the last frame comes the first one, so that
  /// loops play on without waiting. Frames that are no longer ahead make room.
  /// cost O(frames^2) of the window, and the reads;  no allocation
  void prefetch(std::uint32_t next) noexcept;

  operator FrameSource() noexcept;  ///< valid as long as this window; a request for a missing frame starts its read

  std::size_t pending_reads() const noexcept;
  std::uint32_t frames_loaded() const noexcept;  ///< loaded frames; may be called while another thread plays
  std::uint64_t bytes_requested() const noexcept {
    return bytes_requested_;
  }  ///< bytes requested from the reader so far
  std::size_t memory_bytes() const noexcept { return memory_.size(); }

 private:
  FrameRead* find(std::uint32_t frame) noexcept;
  bool is_ahead(std::uint32_t frame) const noexcept;
  FrameRead* ask(std::uint32_t frame) noexcept;
  std::span<const std::byte> bytes(std::uint32_t frame) noexcept;

  const GeometryCache& cache_;
  FrameReader reader_;
  std::vector<std::byte> memory_;
  std::unique_ptr<FrameRead[]> slots_;
  std::uint32_t slot_count_ = 0, next_ = 0;
  std::uint64_t bytes_requested_ = 0;
};

}  // namespace sinew
