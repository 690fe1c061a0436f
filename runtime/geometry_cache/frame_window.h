// SPDX-License-Identifier: MIT
#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "runtime/geometry_cache/geometry_decoder.h"

namespace sinew {

/// A read that the engine was asked for and has not finished yet.
class FrameRead {
 public:
  /// The bytes are there, or could not be read (then the window asks again). Once per read, from any thread.
  void finish(bool ok) noexcept { state_.store(ok ? State::ready : State::empty, std::memory_order_release); }

 private:
  friend class FrameWindow;
  enum class State : std::uint8_t { empty, reading, ready };
  std::atomic<State> state_{State::empty};
  std::uint32_t frame_ = kNone;
  std::span<std::byte> room_;
};

enum class ReadOutcome : std::uint8_t {
  done,     ///< the bytes are there
  pending,  ///< FrameRead::finish will say when
  failed,   ///< asked again when the frame is wanted again
};

/// How the engine reads a file. Several caches may share one: each has its own context, or the reads tell them apart.
struct FrameReader {
  /// Reads into[...] from `offset` of the file, now or later.
  ReadOutcome (*read)(void* context, std::uint64_t offset, std::span<std::byte> into,
                      FrameRead& read) noexcept = nullptr;
  void* context = nullptr;
};

/// A window over the frames of a file that is not in memory: the next ones in the order of play. Its memory is a number
/// of frames, however long the file is.
///
///     window.prefetch(decoder.next_for(frame));   // asks for what is missing of the next frames
///     decoder.decode(frame, window);              // not_there: shows the newest frame that is
class FrameWindow {
 public:
  /// The cache must outlive this, and every read must be finished before this ends (pending_reads).
  /// in   frames  1 or more
  FrameWindow(const GeometryCache& cache, FrameReader reader, std::uint32_t frames);

  /// Asks for frames that are missing, from `next` on. After the last frame comes the first one, so that a loop goes on
  /// without waiting. Frames that are no longer ahead make room.
  /// cost O(frames^2) of the window, and the reads;  no allocation
  void prefetch(std::uint32_t next) noexcept;

  operator FrameSource() noexcept;  ///< valid as long as this; a frame that is missing is asked for

  std::size_t pending_reads() const noexcept;
  std::uint32_t frames_there() const noexcept;                         ///< also while another thread plays
  std::uint64_t bytes_asked() const noexcept { return bytes_asked_; }  ///< of the reader, since this was made
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
  std::uint64_t bytes_asked_ = 0;
};

}  // namespace sinew
