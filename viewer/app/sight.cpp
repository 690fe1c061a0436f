// SPDX-License-Identifier: MIT
#include "viewer/app/sight.h"

#include <algorithm>

namespace sinew::viewer {

bool Unseen::hides_more_than(const Unseen& other) const noexcept {
  for (std::size_t i = 0; i < out_of_view.size(); ++i)
    if (out_of_view[i] > other.out_of_view[i]) return true;
  return false;
}

Unseen Sight::of(std::uint32_t clip, const View& view, double aspect) {
  const bool plays = clip < scene_->animations.size();
  auto& reach = plays ? reach_[clip] : reach_.back();
  if (!reach) reach = clip_bounds(*scene_, needs_, plays ? clip : kNone);
  Unseen unseen = nothing();
  for (std::size_t i = 0; i < reach->size(); ++i)
    unseen.out_of_view[i] = is_out_of_view(view, aspect, view.view_from_world, (*reach)[i]);
  unseen.all =
      !reach->empty() && std::find(unseen.out_of_view.begin(), unseen.out_of_view.end(), 0) == unseen.out_of_view.end();
  return unseen;
}

void leave_out(const Unseen& unseen, bool joints_watched, FrameInput& input) {
  input.out_of_view = unseen.out_of_view;
  input.asleep = unseen.all && !joints_watched;
}

}  // namespace sinew::viewer
