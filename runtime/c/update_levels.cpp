// SPDX-License-Identifier: MIT
#include "runtime/c/update_levels.h"

#include <algorithm>
#include <cmath>

#include "runtime/c/frame_input.h"
#include "runtime/c/glue/call.h"
#include "runtime/c/glue/enums.h"
#include "runtime/c/glue/fields.h"
#include "runtime/lod/interpolated_input.h"
#include "runtime/lod/update_rate.h"

using namespace sinew;

namespace {

constexpr auto kRates = c::fields(c::field<&sinew_update_rates::second_below, &UpdateRates::second_below>(),
                                  c::field<&sinew_update_rates::fourth_below, &UpdateRates::fourth_below>(),
                                  c::field<&sinew_update_rates::hysteresis, &UpdateRates::hysteresis>(),
                                  c::field<&sinew_update_rates::longest_s, &UpdateRates::longest_s>());

bool has_nan(double size, double frame_s, const UpdateRates& rates) noexcept {
  const double numbers[] = {size, frame_s, rates.second_below, rates.fourth_below, rates.hysteresis, rates.longest_s};
  return std::any_of(std::begin(numbers), std::end(numbers), [](double number) { return std::isnan(number); });
}

bool has_pages(std::span<const ClipLayer> layers) noexcept {
  return std::any_of(layers.begin(), layers.end(), [](const ClipLayer& layer) { return layer.page != nullptr; });
}

/// Room for the input of a C caller, and for the input that is returned to it.
struct Rooms {
  explicit Rooms(const sinew_plan& of) : plan(&of), in(of), out(of) {}

  /// Reads the input of this frame, and the level from its number.
  sinew_error read(const sinew_frame_input* given, std::uint32_t number, FrameInput& input, UpdateLevel& level) const {
    if (const sinew_error error = c::from_c(number, level)) return error;
    return c::read_input(given, *plan, in.room(), input).error;
  }

  const sinew_plan* plan;
  c::OwnRoom<c::InputRoom> in;
  c::OwnRoom<c::InputRoomOfC> out;
};

}  // namespace

struct sinew_held_input {
  explicit sinew_held_input(const sinew_plan& of) : rooms(of), held(of.plan) {}

  Rooms rooms;
  HeldInput held;
};

struct sinew_interpolated_input {
  explicit sinew_interpolated_input(const sinew_plan& of)
      : rooms(of), ahead(of.plan.needs().in.layer_room()), interpolated(of.plan) {}

  Rooms rooms;
  std::vector<ClipLayer> ahead;
  InterpolatedInput interpolated;
};

sinew_update_rates sinew_default_update_rates(void) { return c::written<sinew_update_rates>(kRates, UpdateRates{}); }

double sinew_screen_size(double radius_m, double distance_m, double fov_y_rad) {
  return screen_size(radius_m, distance_m, fov_y_rad);
}

sinew_error sinew_choose_update_level(double size, std::uint32_t before, double frame_s,
                                      const sinew_update_rates* rates, std::uint32_t* level) {
  return c::call(c::given(level), [&] {
    UpdateRates own;
    UpdateLevel last = UpdateLevel::every;
    if (const sinew_error error = c::read_fields(rates, kRates, own)) return error;
    if (const sinew_error error = c::from_c(before, last)) return error;
    if (has_nan(size, frame_s, own)) return SINEW_NOT_FINITE;
    *level = c::to_c(limited_level(update_level(size, last, own), frame_s, own));
    return SINEW_OK;
  });
}

std::uint32_t sinew_frames_to_update(std::uint32_t level, std::uint64_t frame, std::uint32_t phase) {
  UpdateLevel own = UpdateLevel::every;
  return c::from_c(level, own) == SINEW_OK ? frames_to_update(own, frame, phase) : 0;
}

sinew_error sinew_held_input_create(const sinew_plan* plan, sinew_held_input** out) {
  return c::call(c::given(plan, out), [&] { *out = new sinew_held_input(*plan); });
}

void sinew_held_input_destroy(sinew_held_input* held) { delete held; }

sinew_error sinew_held_input_next(sinew_held_input* held, const sinew_frame_input* now, std::uint32_t level,
                                  std::uint64_t frame, std::uint32_t phase, sinew_frame_input* input) {
  return c::call(c::given(held, input), [&] {
    FrameInput own;
    UpdateLevel at = UpdateLevel::every;
    if (const sinew_error error = held->rooms.read(now, level, own, at)) return error;
    return c::write_input(held->held.next(own, at, frame, phase), held->rooms.out.room(), input);
  });
}

sinew_error sinew_interpolated_input_create(const sinew_plan* plan, sinew_interpolated_input** out) {
  return c::call(c::given(plan, out), [&] {
    if (!plan->plan.needs().in.between_updates) return SINEW_NOT_IN_NEEDS;
    *out = new sinew_interpolated_input(*plan);
    return SINEW_OK;
  });
}

void sinew_interpolated_input_destroy(sinew_interpolated_input* interpolated) { delete interpolated; }

sinew_error sinew_interpolated_input_next(sinew_interpolated_input* interpolated, const sinew_frame_input* now,
                                          const sinew_layer* ahead, std::size_t ahead_count, std::uint32_t level,
                                          std::uint64_t frame, std::uint32_t phase, sinew_frame_input* input) {
  return c::call(c::given(interpolated, input), [&] {
    FrameInput own;
    UpdateLevel at = UpdateLevel::every;
    if (const sinew_error error = interpolated->rooms.read(now, level, own, at)) return error;
    if (has_pages(own.layers)) return SINEW_UNSUPPORTED;  // the caller cannot give the pages of `ahead`
    std::span<const ClipLayer> next;
    if (const sinew_error error = c::read_layers(ahead, ahead_count, "ahead", interpolated->ahead, next).error)
      return error;
    return c::write_input(interpolated->interpolated.next(own, next, at, frame, phase), interpolated->rooms.out.room(),
                          input);
  });
}

void sinew_interpolated_input_restart(sinew_interpolated_input* interpolated) {
  if (interpolated != nullptr) interpolated->interpolated.restart();
}
