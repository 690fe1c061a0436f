// SPDX-License-Identifier: MIT
#include "runtime/geometry_cache/frame_window.h"

#include <algorithm>

#include "runtime/base/contract.h"

namespace sinew {

FrameWindow::FrameWindow(const GeometryCache& cache, FrameReader reader, std::uint32_t frames)
    : cache_(cache), reader_(reader), slot_count_(std::min(frames, cache.frame_count())) {
  CONTRACT(frames > 0);
  const std::size_t room = cache.largest_frame();
  memory_.resize(slot_count_ * room);
  slots_ = std::make_unique<FrameRead[]>(slot_count_);
  for (std::uint32_t s = 0; s < slot_count_; ++s) slots_[s].room_ = std::span(memory_).subspan(s * room, room);
}

FrameRead* FrameWindow::find(std::uint32_t frame) noexcept {
  for (std::uint32_t s = 0; s < slot_count_; ++s)
    if (slots_[s].frame_ == frame && slots_[s].state_.load(std::memory_order_acquire) != FrameRead::State::empty)
      return &slots_[s];
  return nullptr;
}

bool FrameWindow::is_ahead(std::uint32_t frame) const noexcept {
  const std::uint32_t count = cache_.frame_count(), ahead = (frame + count - next_) % count;
  return frame < count && ahead < slot_count_;
}

/// Starts to read a frame if a slot is free for it.
FrameRead* FrameWindow::ask(std::uint32_t frame) noexcept {
  for (std::uint32_t s = 0; s < slot_count_; ++s) {
    FrameRead& slot = slots_[s];
    const auto state = slot.state_.load(std::memory_order_acquire);
    const bool is_free =
        state == FrameRead::State::empty || (state == FrameRead::State::ready && !is_ahead(slot.frame_));
    if (!is_free) continue;
    const GeometryFrame& at = cache_.frames()[frame];
    slot.frame_ = frame;
    slot.state_.store(FrameRead::State::reading, std::memory_order_relaxed);
    bytes_requested_ += at.size;
    const ReadOutcome outcome = reader_.read(reader_.context, at.offset, slot.room_.first(at.size), slot);
    if (outcome != ReadOutcome::pending) slot.finish(outcome == ReadOutcome::done);
    return &slot;
  }
  return nullptr;
}

void FrameWindow::prefetch(std::uint32_t next) noexcept {
  next_ = std::min(next, cache_.frame_count() - 1);
  for (std::uint32_t k = 0; k < slot_count_; ++k) {
    const std::uint32_t frame = (next_ + k) % cache_.frame_count();
    if (find(frame) == nullptr) ask(frame);
  }
}

std::span<const std::byte> FrameWindow::bytes(std::uint32_t frame) noexcept {
  FrameRead* slot = find(frame);
  if (slot == nullptr) {
    next_ = frame;  // earlier frames have been decoded and make room
    slot = ask(frame);
  }
  if (slot == nullptr || slot->state_.load(std::memory_order_acquire) != FrameRead::State::ready) return {};
  return slot->room_.first(cache_.frames()[frame].size);
}

FrameWindow::operator FrameSource() noexcept {
  const auto bytes_of = [](void* window, std::uint32_t frame) noexcept {
    return static_cast<FrameWindow*>(window)->bytes(frame);
  };
  const auto prefetch = [](void* window, std::uint32_t next) noexcept {
    static_cast<FrameWindow*>(window)->prefetch(next);
  };
  return {bytes_of, this, prefetch};
}

std::uint32_t FrameWindow::frames_loaded() const noexcept {
  std::uint32_t count = 0;
  for (std::uint32_t s = 0; s < slot_count_; ++s)
    count += slots_[s].state_.load(std::memory_order_acquire) == FrameRead::State::ready;
  return count;
}

std::size_t FrameWindow::pending_reads() const noexcept {
  std::size_t count = 0;
  for (std::uint32_t s = 0; s < slot_count_; ++s)
    count += slots_[s].state_.load(std::memory_order_acquire) == FrameRead::State::reading;
  return count;
}

}  // namespace sinew
