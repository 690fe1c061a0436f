// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "runtime/base/api.h"
#include "runtime/model/scene.h"
#include "runtime/plan/needs.h"

namespace sinew {

/// The joint of a scene that stands for another one in the poses of a plan.
struct JointMapping {
  std::uint32_t kept_joint = 0;  ///< index in the scene: the joint itself, or the nearest one above that poses have
  std::uint32_t pose_index = 0;  ///< index of `kept_joint` in poses
  bool is_kept = true;           ///< true if `kept_joint` is the joint itself
  Affined kept_from_joint;       ///< from the joint's space to that of `kept_joint`; the identity if they are the same
};

/// The skeleton, clips, skins and correctives that poses are made of. They are the scene's own. With a
/// Needs::out.skeleton_lod they are copies for the joints that it keeps, in the order of the scene. Immutable. Clips
/// are shared with the scene, and pointers refer to all other parts. Internal to plan/.
struct PlanAssets {
  const Skeleton* skeleton = nullptr;  ///< [K joints] skeleton of poses
  std::vector<Clip> clips;             ///< [clips of the plan]
  std::vector<const Skin*> skins;      ///< [skins of the scene] inverse bind matrices lead to a kept joint
  std::span<const PoseCorrective> correctives;
  std::shared_ptr<const MirrorMap> mirror;  ///< for the joints that poses have; null if the needs have none
  std::vector<JointMapping> joint_map;      ///< [J] for each joint of the scene
  std::shared_ptr<const void> copies;       ///< owns reduced copies of the above; null if all joints are kept

  std::size_t joint_count() const noexcept { return skeleton->joint_count(); }
  bool leaves_out() const noexcept { return joint_count() < joint_map.size(); }
};

/// Maps each joint of a scene to a joint that poses keep.
/// in   mirror  its partners of kept joints are kept too; null = none
/// out  [J]     cost O(J)
SINEW_API std::vector<JointMapping> map_joints(const Scene& scene, const SkeletonLod& detail,
                                               const MirrorMap* mirror = nullptr);

/// The joints of a map that poses have, rising.
SINEW_API std::vector<std::uint32_t> kept_joints(std::span<const JointMapping> joint_map);

/// Makes the assets of a plan. They point into the scene, except for their clips.
/// in   clips  of the scene's joints, morph weights and properties
/// cost O(J + clips), or O(size of skeleton, clips and skins) where joints are left out; allocates
SINEW_API PlanAssets make_assets(const Scene& scene, std::span<const Clip> clips, const SkeletonLod& detail,
                                 const std::shared_ptr<const MirrorMap>& mirror = nullptr);

/// World matrix of any joint of the scene.
/// in   model[K]  of a frame (FrameResult::model)
inline Affine world_of(const PlanAssets& assets, std::span<const Affine> model, std::uint32_t joint) noexcept {
  const JointMapping& mapped = assets.joint_map[joint];
  const Affine& kept = model[mapped.pose_index];
  return mapped.is_kept ? kept : affine_cast<float>(affine_cast<double>(kept) * mapped.kept_from_joint);
}

}  // namespace sinew
