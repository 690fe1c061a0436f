// SPDX-License-Identifier: MIT
#include "runtime/retarget/feet_map.h"

#include <algorithm>
#include <optional>
#include <string>

#include "runtime/retarget/humanoid_bones.h"
#include "runtime/retarget/leg_pose.h"
#include "runtime/retarget/rest_transform.h"
#include "runtime/retarget/retarget_animation.h"

namespace sinew {
namespace {

using Vec3d = Vec3<double>;

std::vector<LegJoints> humanoid_legs(const std::vector<std::uint32_t>& bones) {
  std::vector<LegJoints> legs;
  for (const std::string side : {"left", "right"}) {
    const auto joint = [&](const char* bone) { return bones[humanoid_bone(side + bone)]; };
    legs.push_back({joint("UpperLeg"), joint("LowerLeg"), joint("Foot"), joint("Toes")});
  }
  return legs;
}

std::size_t place_in(const std::vector<LegJoint>& joints, std::uint32_t joint) {
  const auto found = std::find_if(joints.begin(), joints.end(), [&](const LegJoint& j) { return j.joint == joint; });
  return static_cast<std::size_t>(found - joints.begin());
}

/// The chain of a leg; empty if its joints are not descendants of each other.
std::optional<LegChain> chain_of(const Skeleton& skeleton, const LegJoints& leg) {
  const auto chain_to = [&](std::uint32_t tip) {
    std::vector<LegJoint> joints;
    for (std::uint32_t j = tip; j != kNone; j = skeleton.parents[j])
      joints.push_back({j, skeleton.fixed_matrix_of[j] != kNone, rest_transform(skeleton, j)});
    std::reverse(joints.begin(), joints.end());
    return joints;
  };
  if (leg.foot == kNone) return std::nullopt;
  LegChain chain{chain_to(leg.foot)};
  chain.foot = chain.joints.size() - 1;
  chain.upper = place_in(chain.joints, leg.upper);
  chain.lower = place_in(chain.joints, leg.lower);
  if (chain.lower >= chain.foot || chain.upper >= chain.lower) return std::nullopt;
  if (leg.toes == kNone) return chain;
  std::vector<LegJoint> to_toes = chain_to(leg.toes);
  if (place_in(to_toes, leg.foot) != chain.foot || leg.toes == leg.foot) return chain;
  chain.joints = std::move(to_toes);
  chain.toes = chain.joints.size() - 1;
  return chain;
}

/// Direction of the knee of a straight leg: as it is bent at rest, or else where the toes point.
Vec3d bend_of(const LegPose<double>& rest, bool has_toes) {
  constexpr double kBent = 0.01;  // as a fraction of the leg's length
  const Vec3d whole = rest.foot.place - rest.upper.place, along = normalised_or(whole, Vec3d(0, -1, 0));
  const Vec3d knee = rest.lower.place - rest.upper.place, off = knee - along * glm::dot(knee, along);
  Vec3d bend(0, 0, 1);
  if (has_toes) bend = rest.toes.place - rest.foot.place;
  if (safe_length(off) > kBent * safe_length(whole)) bend = off;
  return rotate_vector(quat_conjugate(rest.upper.rotation), normalised_or(bend, Vec3d(0, 0, 1)));
}

/// Finds the hips, a joint at the top of the map and above all legs, and its index in their chains.
void find_hips(const SkeletonMap& map, FeetMap& feet) {
  for (const MappedJoint& joint : map.joints) {
    if (joint.above_target != kNone) continue;
    const bool is_above_all = std::all_of(feet.legs.begin(), feet.legs.end(), [&](LegPair& leg) {
      leg.target.hips = place_in(leg.target.joints, joint.target);
      return leg.target.hips < leg.target.upper && !leg.target.joints[leg.target.hips].is_fixed;
    });
    if (!is_above_all) continue;
    feet.hips = joint.target;
    return;
  }
}

double length_of(const LegPose<double>& leg) {
  return safe_length(leg.lower.place - leg.upper.place) + safe_length(leg.foot.place - leg.lower.place);
}

}  // namespace

FeetMap make_feet_map(const SkeletonMap& map, const Skeleton& source, const Skeleton& target,
                      const std::vector<LegJoints>& legs) {
  std::vector<Transformd> rest(source.joint_count()), like_rest(target.joint_count());
  for (std::uint32_t j = 0; j < rest.size(); ++j) rest[j] = reference_transform(source, map.source_pose, j);
  retarget_pose(map, source, target, rest, like_rest);
  std::vector<std::uint32_t> source_of(target.joint_count(), kNone);
  for (const MappedJoint& joint : map.joints) source_of[joint.target] = joint.source;

  FeetMap feet{{}, map.height_ratio};
  for (const LegJoints& leg : legs.empty() ? humanoid_legs(map.target_bones) : legs) {
    const auto from = [&](std::uint32_t joint) { return joint == kNone ? kNone : source_of[joint]; };
    auto on_target = chain_of(target, leg);
    auto on_source = chain_of(source, {from(leg.upper), from(leg.lower), from(leg.foot), from(leg.toes)});
    if (!on_target || !on_source) continue;
    const auto from_rest = leg_pose<double>(*on_source, [&](std::uint32_t j) { return rest[j]; });
    const auto to_rest = leg_pose<double>(*on_target, [&](std::uint32_t j) { return like_rest[j]; });
    if (on_source->toes == 0 || on_target->toes == 0) on_source->toes = on_target->toes = 0;
    LegPair pair;
    pair.source_foot = from_rest.foot.place;
    pair.source_toes = from_rest.toes.place;
    pair.target_foot = to_rest.foot.place;
    pair.target_toes = to_rest.toes.place;
    pair.bend = bend_of(to_rest, on_target->toes != 0);
    pair.source_length = length_of(from_rest);
    pair.target_length = length_of(to_rest);
    pair.source = *std::move(on_source);
    pair.target = *std::move(on_target);
    feet.legs.push_back(std::move(pair));
  }
  find_hips(map, feet);
  return feet;
}

}  // namespace sinew
