// SPDX-License-Identifier: MIT
#include "runtime/clip/clip_rest.h"

#include "runtime/base/same_bits.h"
#include "runtime/clip/clip_layout.h"

namespace sinew {

ClipRest clip_rest(const Skeleton& skeleton, std::span<const float> rest_weights, const PropertyTable& properties) {
  return {skeleton.joint_count(), rest_numbers(BasePose(skeleton.rest).planes),
          rest_numbers({rest_weights.begin(), rest_weights.end()}), rest_numbers(properties.rest)};
}

void share_rest(const Clip& clip, ClipRest& rest) {
  const auto share = [](const BaseNumbers& theirs, RestNumbers& ours) {
    if (theirs.rest() != nullptr && same_bits<float>(*theirs.rest(), *ours)) ours = theirs.rest();
  };
  share(clip.layout().base_pose, rest.pose);
  share(clip.layout().base_weights, rest.weights);
  share(clip.layout().base_properties, rest.properties);
}

}  // namespace sinew
