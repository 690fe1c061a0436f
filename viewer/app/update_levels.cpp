// SPDX-License-Identifier: MIT
#include "viewer/app/update_levels.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "runtime/math/quaternion.h"

namespace sinew::viewer {
namespace {

double size_of(const Aabb& box, const View& view) noexcept {
  const Vec3<double> lower(box.lower), upper(box.upper);
  const double radius_m = 0.5 * safe_length(upper - lower);
  if (view.parallel()) return radius_m / view.half_height_m;
  return screen_size(radius_m, safe_length(transform_point(view.view_from_world, 0.5 * (lower + upper))),
                     view.fov_y_rad);
}

const char* how_often(UpdateLevel level) noexcept {
  switch (level) {
    case UpdateLevel::every: return "every frame";
    case UpdateLevel::every_second: return "every 2nd frame";
    case UpdateLevel::every_fourth: break;
  }
  return "every 4th frame";
}

}  // namespace

std::string_view name_of(Updates updates) noexcept {
  switch (updates) {
    case Updates::every: return "every";
    case Updates::interpolated: return "interpolated";
    case Updates::held: break;
  }
  return "held";
}

double size_in_picture(const FrameResult& frame, const View& view) noexcept {
  double largest = 0.0;
  for (const InstanceResult& instance : frame.instances)
    if (instance.visible && !instance.bounds.empty()) largest = std::max(largest, size_of(instance.bounds, view));
  return largest;
}

UpdateLevels::UpdateLevels(const Plan& plan, Updates updates) : updates_(updates), held_(plan) {
  if (updates == Updates::interpolated) between_.emplace(plan);
}

void UpdateLevels::begin_frame(double size, double frame_s) noexcept {
  ++frame_;
  size_ = size;
  why_exact_.clear();
  by_size_ = updates_ == Updates::every ? UpdateLevel::every : update_level(size, by_size_);
  level_ = limited_level(by_size_, frame_s);
}

void UpdateLevels::begin_exact_frame(std::string_view why) {
  ++frame_;
  why_exact_ = why;
  level_ = UpdateLevel::every;
  if (between_) between_->restart();
}

FrameInput UpdateLevels::input(const FrameInput& now, std::span<const ClipLayer> ahead) {
  if (between_) return between_->next(now, ahead, level_, frame_, 0);
  return updates_ == Updates::held ? held_.next(now, level_, frame_, 0) : now;
}

std::string UpdateLevels::reason() const {
  const std::string often = how_often(level_);
  if (!why_exact_.empty()) return often + ": " + why_exact_;
  if (updates_ == Updates::every) return often + ", as asked";
  if (level_ != by_size_ && level_ == UpdateLevel::every)
    return often + ": pictures are too far apart to leave any out";
  const std::string how = level_ == UpdateLevel::every ? ""
                          : updates_ == Updates::held  ? ", held in between"
                                                       : ", interpolated in between";
  if (size_ == 0.0) return often + how + ": no mesh is in view";
  if (size_ >= 1.0) return often + how + ": meshes fill the picture's height";
  char text[64];
  std::snprintf(text, sizeof(text), ": %.2g %% of the picture's height", 100.0 * size_);
  return often + how + text;
}

}  // namespace sinew::viewer
