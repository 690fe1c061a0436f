// SPDX-License-Identifier: MIT
#include "runtime/lod/interpolated_input.h"

#include <utility>

#include "runtime/base/contract.h"

namespace sinew {

std::uint32_t frames_to_update(UpdateLevel level, std::uint64_t frame, std::uint32_t phase) noexcept {
  const std::uint64_t period = std::uint64_t{1} << static_cast<unsigned>(level);
  return static_cast<std::uint32_t>(period - (frame + phase) % period);
}

InterpolatedInput::InterpolatedInput(const Plan& plan) {
  CONTRACT(plan.needs().in.between_updates);
  from_.reserve(plan.needs().in.layer_room());
  to_.reserve(plan.needs().in.layer_room());
}

FrameInput InterpolatedInput::next(const FrameInput& now, std::span<const ClipLayer> ahead, UpdateLevel level,
                                   std::uint64_t frame, std::uint32_t phase) {
  const bool as_it_is = now.asleep || !now.program.empty();
  if (as_it_is || frame < start_ || frame > end_) moves_ = false;
  if (as_it_is) return now;
  if (!moves_ || frame == end_) {
    if (level == UpdateLevel::every) {
      moves_ = false;
      return now;
    }
    if (moves_)
      std::swap(from_, to_);
    else
      from_.assign(now.layers.begin(), now.layers.end());
    to_.assign(ahead.begin(), ahead.end());
    start_ = frame;
    end_ = frame + frames_to_update(level, frame, phase);
    moves_ = true;
  }
  FrameInput between = now;
  between.layers = from_;
  between.next_layers = to_;
  between.interpolation_factor = static_cast<float>(frame - start_) / static_cast<float>(end_ - start_);
  return between;
}

}  // namespace sinew
