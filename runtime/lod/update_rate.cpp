// SPDX-License-Identifier: MIT
#include "runtime/lod/update_rate.h"

#include <cmath>
#include <limits>

#include "runtime/plan/playing_layers.h"

namespace sinew {

double screen_size(double radius_m, double distance_m, double fov_y_rad) noexcept {
  if (!(distance_m > radius_m)) return std::numeric_limits<double>::infinity();
  return radius_m / (distance_m * std::tan(0.5 * fov_y_rad));
}

UpdateLevel update_level(double screen_size, UpdateLevel before, const UpdateRates& rates) noexcept {
  const auto is_below = [&](double border, UpdateLevel level) {
    return screen_size < (before >= level ? border * (1.0 + rates.hysteresis) : border);
  };
  if (is_below(rates.fourth_below, UpdateLevel::every_fourth)) return UpdateLevel::every_fourth;
  return is_below(rates.second_below, UpdateLevel::every_second) ? UpdateLevel::every_second : UpdateLevel::every;
}

UpdateLevel limited_level(UpdateLevel level, double frame_s, const UpdateRates& rates) noexcept {
  unsigned finer = static_cast<unsigned>(level);
  while (finer > 0 && frame_s * static_cast<double>(1u << finer) > rates.longest_s) --finer;
  return static_cast<UpdateLevel>(finer);
}

FrameInput HeldInput::next(const FrameInput& now, UpdateLevel level, std::uint64_t frame, std::uint32_t phase) {
  const std::uint64_t period = std::uint64_t{1} << static_cast<unsigned>(level);
  const bool is_due = (frame + phase) % period == 0;
  if (now.asleep) {
    holds_ = false;
    return now;
  }
  if (is_due || !holds_) {
    FrameInput kept = now;
    kept.program_inputs = inputs_in_use(now);
    const bool has_lists = !kept.program.empty() || !kept.program_inputs.masks.empty();
    if (has_lists && held_.check_room(kept) != ErrorCode::ok) {
      holds_ = false;
      return now;  // run_plan then says what is wrong
    }
    held_.assign(kept);
    holds_ = true;
  }
  FrameInput input = held_.view();
  input.out_of_view = now.out_of_view;
  return input;
}

}  // namespace sinew
