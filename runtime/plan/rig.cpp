// SPDX-License-Identifier: MIT
#include "runtime/plan/rig.h"

#include "runtime/animation/truth_pose.h"
#include "runtime/base/contract.h"
#include "runtime/clip/keep_joints.h"

namespace sinew {
namespace {

std::vector<bool> kept_joints(const Scene& scene, const SkeletonLod& detail) {
  std::vector<bool> kept = detail.kept;
  for (const PoseCorrective& corrective : scene.correctives)
    for (const PoseDriver& driver : corrective.samples.drivers) kept[driver.joint] = true;
  const std::vector<std::uint32_t>& parents = scene.skeleton.parents;
  for (std::size_t j = kept.size(); j-- > 0;)
    if (parents[j] == kNone)
      kept[j] = true;
    else if (kept[j])
      kept[parents[j]] = true;
  return kept;
}

Affined held_matrix(const Skeleton& skeleton, const SkeletonLod& detail, std::uint32_t joint) {
  const std::uint32_t fixed = skeleton.fixed_matrix_of[joint];
  if (fixed != kNone) return affine_cast<double>(skeleton.fixed_matrices[fixed]);
  return affine_from_transform(in_double(detail.held.empty() ? skeleton.rest[joint] : detail.held[joint]));
}

/// The parts of a rig that know some joints alone.
struct Copies {
  Skeleton skeleton;
  std::vector<Clip> clips;
  std::vector<Skin> skins;
  std::vector<PoseCorrective> correctives;
};

Copies copy_parts(const Scene& scene, const std::vector<JointPlace>& places) {
  std::vector<std::uint32_t> joints;
  for (std::uint32_t j = 0; j < places.size(); ++j)
    if (places[j].is_kept) joints.push_back(j);
  Copies copies{keep_joints(scene.skeleton, joints), {}, scene.skins, scene.correctives};
  for (const Clip& clip : scene.clips) copies.clips.push_back(keep_joints(clip, joints));
  for (Skin& skin : copies.skins)
    for (std::size_t i = 0; i < skin.joints.size(); ++i) {
      const JointPlace& place = places[skin.joints[i]];
      skin.joints[i] = place.at;
      if (!place.is_kept)
        skin.inverse_bind[i] = affine_cast<float>(place.from_joint * affine_cast<double>(skin.inverse_bind[i]));
    }
  for (PoseCorrective& corrective : copies.correctives)
    for (PoseDriver& driver : corrective.samples.drivers) driver.joint = places[driver.joint].at;
  return copies;
}

void point_at(const Skeleton& skeleton, const std::vector<Clip>& clips, const std::vector<Skin>& skins,
              std::span<const PoseCorrective> correctives, Rig& rig) {
  rig.skeleton = &skeleton;
  for (const Clip& clip : clips) rig.clips.push_back(&clip);
  for (const Skin& skin : skins) rig.skins.push_back(&skin);
  rig.correctives = correctives;
}

}  // namespace

std::vector<JointPlace> place_joints(const Scene& scene, const SkeletonLod& detail) {
  const Skeleton& skeleton = scene.skeleton;
  CONTRACT(detail.kept.empty() || detail.kept.size() == skeleton.joint_count());
  CONTRACT(detail.held.empty() || detail.held.size() == skeleton.joint_count());
  const std::vector<bool> kept =
      detail.kept.empty() ? std::vector<bool>(skeleton.joint_count(), true) : kept_joints(scene, detail);
  std::vector<JointPlace> places(skeleton.joint_count());
  std::uint32_t count = 0;
  for (std::uint32_t j = 0; j < places.size(); ++j) {
    if (kept[j]) {
      places[j] = {j, count++, true, {}};
      continue;
    }
    places[j] = places[skeleton.parents[j]];
    places[j].is_kept = false;
    places[j].from_joint = places[j].from_joint * held_matrix(skeleton, detail, j);
  }
  return places;
}

Rig make_rig(const Scene& scene, const SkeletonLod& detail) {
  Rig rig;
  rig.places = place_joints(scene, detail);
  bool all = true;
  for (const JointPlace& place : rig.places) all = all && place.is_kept;
  if (all) {
    point_at(scene.skeleton, scene.clips, scene.skins, scene.correctives, rig);
    return rig;
  }
  const auto copies = std::make_shared<const Copies>(copy_parts(scene, rig.places));
  point_at(copies->skeleton, copies->clips, copies->skins, copies->correctives, rig);
  rig.copies = copies;
  return rig;
}

}  // namespace sinew
