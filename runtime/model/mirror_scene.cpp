// SPDX-License-Identifier: MIT
#include "runtime/model/mirror_scene.h"

#include <array>
#include <utility>

#include "runtime/animation/mirror_pairs.h"
#include "runtime/animation/side_names.h"
#include "runtime/model/bind_pose.h"

namespace sinew {

namespace {

std::vector<std::array<std::uint32_t, 2>> partners_of(const JointPairs& pairs) {
  std::vector<std::array<std::uint32_t, 2>> partners;
  for (std::uint32_t j = 0; j < pairs.partner.size(); ++j)
    if (pairs.partner[j] > j) partners.push_back({j, pairs.partner[j]});
  return partners;
}

}  // namespace

MirrorReference mirror_reference(const Scene& scene, const MirrorOptions& options) {
  constexpr double kSymmetric = 1e-3, kMoreSymmetric = 0.5;
  const Skeleton& skeleton = scene.skeleton;
  MirrorReference chosen{PoseReference::rest, skeleton.rest, 0.0, 0.0};
  BindPose bind = bind_pose(scene);
  if (bind.differs.empty()) return chosen;
  const ReferencePose rested = reference_pose(skeleton, skeleton.rest), bound = reference_pose(skeleton, bind.local);
  const JointPairs of_rest = pair_joints(skeleton, rested, options), of_bind = pair_joints(skeleton, bound, options);
  const auto rest_partners = partners_of(of_rest), bind_partners = partners_of(of_bind);
  const bool bind_has_more = bind_partners.size() >= rest_partners.size();
  // Both poses are judged by the same joints and partners. Pairing by positions would only find joints near their
  // image.
  MirrorOptions common = options;
  common.pairs = bind_has_more ? bind_partners : rest_partners;
  for (const auto& pair : options.pairs)
    if (pair[0] == pair[1]) common.pairs.push_back(pair);
  const std::vector<std::uint32_t> judged = symmetric_joints(bind_has_more ? of_bind : of_rest);
  chosen.rest_asymmetry = asymmetry_of(rested, pair_joints(skeleton, rested, common), judged);
  chosen.bind_asymmetry = asymmetry_of(bound, pair_joints(skeleton, bound, common), judged);
  if (chosen.rest_asymmetry <= kSymmetric || chosen.bind_asymmetry >= kMoreSymmetric * chosen.rest_asymmetry)
    return chosen;
  chosen.pose = PoseReference::bind;
  chosen.local = std::move(bind.local);
  return chosen;
}

MirrorMap make_mirror_map(const Scene& scene, const MirrorOptions& options) {
  MirrorReference chosen;
  MirrorOptions about = options;
  if (options.reference.empty()) {
    chosen = mirror_reference(scene, options);
    about.reference = chosen.local;
  }
  MirrorMap map = make_mirror_map(scene.skeleton, about);
  if (options.reference.empty()) map.reference = chosen.pose;
  bool moves = false;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const std::vector<std::string>& names = scene.meshes[scene.instances[i].mesh].target_names;
    const std::uint32_t first = scene.first_weight[i], count = scene.first_weight[i + 1] - first;
    std::vector<std::uint32_t> partners = name_partners(names);
    for (std::uint32_t t = 0; t < count; ++t) {
      const std::uint32_t from = names.size() == count ? partners[t] : t;
      map.weight_source.push_back(first + from);
      moves |= from != t;
    }
  }
  if (!moves) map.weight_source.clear();
  return map;
}

}  // namespace sinew
