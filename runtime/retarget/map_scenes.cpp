// SPDX-License-Identifier: MIT
#include "runtime/retarget/map_scenes.h"

#include <span>
#include <utility>
#include <vector>

#include "runtime/model/bind_pose.h"

namespace sinew {
namespace {

/// The reference poses that a body may have.
class References {
 public:
  References(const Scene& scene, std::span<const Transform> given) {
    poses_ = {{given}};
    if (!given.empty()) return;
    BindPose bind = bind_pose(scene);
    if (bind.differs.empty()) return;
    bind_ = std::move(bind.local);
    poses_.push_back({bind_, true});
  }

  struct Pose {
    std::span<const Transform> local;  // empty = the rest pose
    bool is_bind = false;
  };
  const std::vector<Pose>& poses() const noexcept { return poses_; }

 private:
  std::vector<Transform> bind_;
  std::vector<Pose> poses_;
};

}  // namespace

SkeletonMap make_skeleton_map(const Scene& source, const Scene& target, const SkeletonMapOptions& options) {
  constexpr double kLeastGain_rad = 0.0087, kLeastShare = 0.25;  // half a degree, a quarter
  const References of_source(source, options.source_reference), of_target(target, options.target_reference);
  SkeletonMap best;
  double first_angle_rad = 0.0;
  bool is_first = true;
  for (const References::Pose& from : of_source.poses())
    for (const References::Pose& to : of_target.poses()) {
      SkeletonMapOptions about = options;
      about.source_reference = from.local;
      about.target_reference = to.local;
      SkeletonMap map = make_skeleton_map(source.skeleton, target.skeleton, about);
      if (from.is_bind) map.source_reference = PoseReference::bind;
      if (to.is_bind) map.target_reference = PoseReference::bind;
      if (is_first) first_angle_rad = map.bone_angle_rad;
      const double gain = first_angle_rad - map.bone_angle_rad;
      const bool is_better =
          gain >= kLeastGain_rad && gain >= kLeastShare * first_angle_rad && map.bone_angle_rad < best.bone_angle_rad;
      if (is_first || is_better) best = std::move(map);
      is_first = false;
    }
  return best;
}

}  // namespace sinew
