// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "runtime/model/scene.h"
#include "runtime/plan/skeleton_lod.h"

namespace sinew {

/// Where a joint of a scene is in the poses of a plan.
struct JointPlace {
  std::uint32_t joint = 0;  ///< of the scene: the joint itself, or the one above that it hangs on
  std::uint32_t at = 0;     ///< the number of that one in poses
  bool is_kept = true;
  Affined from_joint;  ///< how it hangs there; the identity where it is kept
};

/// What poses are made of: the scene's skeleton, clips, skins and correctives, or where a detail leaves joints out
/// copies that know no others, in the order of the scene. Immutable; copies share what they own, and keep pointers into
/// the scene.
struct Rig {
  const Skeleton* skeleton = nullptr;  ///< [K joints]
  std::vector<const Clip*> clips;      ///< [clips of the scene]
  std::vector<const Skin*>
      skins;  ///< [skins of the scene] those that are left out follow by their inverse bind matrices
  std::span<const PoseCorrective> correctives;
  std::vector<JointPlace> places;  ///< [J] of all joints of the scene
  std::shared_ptr<const void> copies;

  std::size_t joint_count() const noexcept { return skeleton->joint_count(); }
  bool leaves_out() const noexcept { return joint_count() < places.size(); }
};

/// cost O(J)
std::vector<JointPlace> place_joints(const Scene& scene, const SkeletonLod& detail);

/// The scene must outlive the rig.     cost O(J), or O(size of skeleton, clips and skins) where joints are left out;
/// allocates
Rig make_rig(const Scene& scene, const SkeletonLod& detail);

/// World matrix of any joint of the scene.
/// in   model[K]  of a frame (FrameResult::model)
inline Affine world_of(const Rig& rig, std::span<const Affine> model, std::uint32_t joint) noexcept {
  const JointPlace& place = rig.places[joint];
  return place.is_kept ? model[place.at] : affine_cast<float>(affine_cast<double>(model[place.at]) * place.from_joint);
}

}  // namespace sinew
