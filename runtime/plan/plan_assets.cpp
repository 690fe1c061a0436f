// SPDX-License-Identifier: MIT
#include "runtime/plan/plan_assets.h"

#include "runtime/animation/truth_pose.h"
#include "runtime/base/contract.h"
#include "runtime/clip/keep_joints.h"

namespace sinew {
namespace {

std::vector<bool> kept_joints(const Scene& scene, const SkeletonLod& detail, const MirrorMap* mirror) {
  std::vector<bool> kept = detail.kept;
  for (const PoseCorrective& corrective : scene.correctives)
    for (const PoseDriver& driver : corrective.samples.drivers) kept[driver.joint] = true;
  if (mirror != nullptr)
    for (std::size_t j = 0; j < kept.size(); ++j)
      if (kept[j]) kept[mirror->joints[j].source] = true;
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

/// Copies of the skeleton and skins for only some joints of a scene.
struct Copies {
  Skeleton skeleton;
  std::vector<Skin> skins;
  std::vector<PoseCorrective> correctives;
};

Copies copy_parts(const Scene& scene, const std::vector<JointMapping>& map,
                  const std::vector<std::uint32_t>& kept_joints) {
  Copies copies{keep_joints(scene.skeleton, kept_joints), scene.skins, scene.correctives};
  for (Skin& skin : copies.skins)
    for (std::size_t i = 0; i < skin.joints.size(); ++i) {
      const JointMapping& mapped = map[skin.joints[i]];
      skin.joints[i] = mapped.pose_index;
      if (!mapped.is_kept)
        skin.inverse_bind[i] = affine_cast<float>(mapped.kept_from_joint * affine_cast<double>(skin.inverse_bind[i]));
    }
  for (PoseCorrective& corrective : copies.correctives)
    for (PoseDriver& driver : corrective.samples.drivers) driver.joint = map[driver.joint].pose_index;
  return copies;
}

/// The same mirror map for only the joints that poses have. Both partners of a pair are kept or left out together.
MirrorMap mirror_of_kept(const MirrorMap& mirror, const std::vector<JointMapping>& map,
                         const std::vector<std::uint32_t>& kept) {
  MirrorMap of_kept = mirror;
  of_kept.joints.clear();
  for (const std::uint32_t j : kept) {
    of_kept.joints.push_back(mirror.joints[j]);
    of_kept.joints.back().source = map[mirror.joints[j].source].pose_index;
  }
  return of_kept;
}

void point_at(const Skeleton& skeleton, const std::vector<Skin>& skins, std::span<const PoseCorrective> correctives,
              PlanAssets& assets) {
  assets.skeleton = &skeleton;
  for (const Skin& skin : skins) assets.skins.push_back(&skin);
  assets.correctives = correctives;
}

}  // namespace

std::vector<JointMapping> map_joints(const Scene& scene, const SkeletonLod& detail, const MirrorMap* mirror) {
  const Skeleton& skeleton = scene.skeleton;
  CONTRACT(detail.kept.empty() || detail.kept.size() == skeleton.joint_count());
  CONTRACT(detail.held.empty() || detail.held.size() == skeleton.joint_count());
  const std::vector<bool> kept =
      detail.kept.empty() ? std::vector<bool>(skeleton.joint_count(), true) : kept_joints(scene, detail, mirror);
  std::vector<JointMapping> map(skeleton.joint_count());
  std::uint32_t count = 0;
  for (std::uint32_t j = 0; j < map.size(); ++j) {
    if (kept[j]) {
      map[j] = {j, count++, true, {}};
      continue;
    }
    map[j] = map[skeleton.parents[j]];
    map[j].is_kept = false;
    map[j].kept_from_joint = map[j].kept_from_joint * held_matrix(skeleton, detail, j);
  }
  return map;
}

std::vector<std::uint32_t> kept_joints(std::span<const JointMapping> joint_map) {
  std::vector<std::uint32_t> kept;
  for (std::uint32_t j = 0; j < joint_map.size(); ++j)
    if (joint_map[j].is_kept) kept.push_back(j);
  return kept;
}

PlanAssets make_assets(const Scene& scene, std::span<const Clip> clips, const SkeletonLod& detail,
                       const std::shared_ptr<const MirrorMap>& mirror) {
  PlanAssets assets;
  assets.joint_map = map_joints(scene, detail, mirror.get());
  const std::vector<std::uint32_t> kept = kept_joints(assets.joint_map);
  if (kept.size() == assets.joint_map.size()) {
    assets.clips.assign(clips.begin(), clips.end());
    assets.mirror = mirror;
    point_at(scene.skeleton, scene.skins, scene.correctives, assets);
    return assets;
  }
  assets.clips = keep_joints(clips, kept);
  if (mirror != nullptr)
    assets.mirror = std::make_shared<const MirrorMap>(mirror_of_kept(*mirror, assets.joint_map, kept));
  const auto copies = std::make_shared<const Copies>(copy_parts(scene, assets.joint_map, kept));
  point_at(copies->skeleton, copies->skins, copies->correctives, assets);
  assets.copies = copies;
  return assets;
}

}  // namespace sinew
