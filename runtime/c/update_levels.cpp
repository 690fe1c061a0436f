// SPDX-License-Identifier: MIT
#include "runtime/c/update_levels.h"

#include <algorithm>
#include <cmath>

#include "runtime/c/boundary.h"
#include "runtime/c/frame_input.h"
#include "runtime/lod/interpolated_input.h"
#include "runtime/lod/update_rate.h"

using namespace sinew;

namespace {

static_assert(static_cast<int>(UpdateLevel::every_second) == SINEW_UPDATE_EVERY_SECOND &&
              static_cast<int>(UpdateLevel::every_fourth) == SINEW_UPDATE_EVERY_FOURTH);

/// Room for the input of a C caller on its way in, and for the answer on its way out.
struct BothRooms {
  explicit BothRooms(const sinew_plan& plan)
      : own(plan),
        layers(plan.input_room()),
        pages(plan.input_room()),
        geometry(plan.geometry_room()),
        program(plan.plan.needs().in.program) {}
  c::InputRoom in() noexcept { return own.room(); }
  c::InputRoomOfC out() noexcept { return {layers, pages, geometry, program.room()}; }

 private:
  c::OwnInputRoom own;
  std::vector<sinew_layer> layers;
  std::vector<const sinew_page*> pages;
  std::vector<sinew_geometry_input> geometry;
  c::OwnProgramRoomOfC program;
};

bool has_pages(std::span<const ClipLayer> layers) noexcept {
  return std::any_of(layers.begin(), layers.end(), [](const ClipLayer& layer) { return layer.page != nullptr; });
}

}  // namespace

struct sinew_held_input {
  explicit sinew_held_input(const sinew_plan& of) : plan(&of), room(of), held(of.plan) {}

  const sinew_plan* plan;
  BothRooms room;
  HeldInput held;
};

struct sinew_interpolated_input {
  explicit sinew_interpolated_input(const sinew_plan& of)
      : plan(&of), room(of), ahead(of.plan.needs().in.layer_room()), interpolated(of.plan) {}

  const sinew_plan* plan;
  BothRooms room;
  std::vector<ClipLayer> ahead;
  InterpolatedInput interpolated;
};

sinew_update_rates sinew_default_update_rates(void) {
  const UpdateRates defaults;
  return {.struct_size = sizeof(sinew_update_rates),
          .second_below = defaults.second_below,
          .fourth_below = defaults.fourth_below,
          .hysteresis = defaults.hysteresis,
          .longest_s = defaults.longest_s};
}

double sinew_screen_size(double radius_m, double distance_m, double fov_y_rad) {
  return screen_size(radius_m, distance_m, fov_y_rad);
}

sinew_error sinew_choose_update_level(double size, std::uint32_t before, double frame_s,
                                      const sinew_update_rates* rates, std::uint32_t* level) {
  if (level == nullptr) return SINEW_NULL_ARGUMENT;
  sinew_update_rates given = sinew_default_update_rates();
  if (const sinew_error error = c::read_struct(rates, given); error != SINEW_OK) return error;
  if (before > SINEW_UPDATE_EVERY_FOURTH) return SINEW_UNSUPPORTED;
  for (const double number : {size, frame_s, given.second_below, given.fourth_below, given.hysteresis, given.longest_s})
    if (std::isnan(number)) return SINEW_NOT_FINITE;
  const UpdateRates own{given.second_below, given.fourth_below, given.hysteresis, given.longest_s};
  const UpdateLevel chosen = update_level(size, static_cast<UpdateLevel>(before), own);
  *level = static_cast<std::uint32_t>(limited_level(chosen, frame_s, own));
  return SINEW_OK;
}

std::uint32_t sinew_frames_to_update(std::uint32_t level, std::uint64_t frame, std::uint32_t phase) {
  return level <= SINEW_UPDATE_EVERY_FOURTH ? frames_to_update(static_cast<UpdateLevel>(level), frame, phase) : 0;
}

sinew_error sinew_held_input_create(const sinew_plan* plan, sinew_held_input** out) {
  if (plan == nullptr || out == nullptr) return SINEW_NULL_ARGUMENT;
  return c::guarded([&] {
    *out = new sinew_held_input(*plan);
    return SINEW_OK;
  });
}

void sinew_held_input_destroy(sinew_held_input* held) { delete held; }

sinew_error sinew_held_input_next(sinew_held_input* held, const sinew_frame_input* now, std::uint32_t level,
                                  std::uint64_t frame, std::uint32_t phase, sinew_frame_input* input) {
  if (held == nullptr || input == nullptr) return SINEW_NULL_ARGUMENT;
  if (level > SINEW_UPDATE_EVERY_FOURTH) return SINEW_UNSUPPORTED;
  return c::guarded([&] {
    FrameInput own;
    if (const sinew_error error = c::read_input(now, *held->plan, held->room.in(), own).error; error != SINEW_OK)
      return error;
    return c::write_input(held->held.next(own, static_cast<UpdateLevel>(level), frame, phase), held->room.out(), input);
  });
}

sinew_error sinew_interpolated_input_create(const sinew_plan* plan, sinew_interpolated_input** out) {
  if (plan == nullptr || out == nullptr) return SINEW_NULL_ARGUMENT;
  if (!plan->plan.needs().in.between_updates) return SINEW_NOT_IN_NEEDS;
  return c::guarded([&] {
    *out = new sinew_interpolated_input(*plan);
    return SINEW_OK;
  });
}

void sinew_interpolated_input_destroy(sinew_interpolated_input* interpolated) { delete interpolated; }

sinew_error sinew_interpolated_input_next(sinew_interpolated_input* interpolated, const sinew_frame_input* now,
                                          const sinew_layer* ahead, std::size_t ahead_count, std::uint32_t level,
                                          std::uint64_t frame, std::uint32_t phase, sinew_frame_input* input) {
  if (interpolated == nullptr || input == nullptr) return SINEW_NULL_ARGUMENT;
  if (level > SINEW_UPDATE_EVERY_FOURTH) return SINEW_UNSUPPORTED;
  return c::guarded([&] {
    FrameInput own;
    std::span<const ClipLayer> next;
    sinew_error error = c::read_input(now, *interpolated->plan, interpolated->room.in(), own).error;
    if (error == SINEW_OK && has_pages(own.layers)) error = SINEW_UNSUPPORTED;  // those of `ahead` are not given
    if (error == SINEW_OK)
      error = c::read_layers(ahead, nullptr, ahead_count, "ahead", interpolated->ahead, next).error;
    if (error != SINEW_OK) return error;
    return c::write_input(interpolated->interpolated.next(own, next, static_cast<UpdateLevel>(level), frame, phase),
                          interpolated->room.out(), input);
  });
}

void sinew_interpolated_input_restart(sinew_interpolated_input* interpolated) {
  if (interpolated != nullptr) interpolated->interpolated.restart();
}
