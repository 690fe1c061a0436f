// SPDX-License-Identifier: MIT
#include "runtime/retarget/twist_map.h"

#include <algorithm>
#include <optional>
#include <string>

#include "runtime/retarget/humanoid_bones.h"
#include "runtime/retarget/name_words.h"
#include "runtime/retarget/rest_transform.h"

namespace sinew {
namespace {

/// A limb bone: the joint that turns it, and the joint at its far end.
struct Limb {
  std::uint32_t joint = kNone, tip = kNone;
  bool is_upper = false;
};

std::vector<Limb> limbs_of(const Skeleton& skeleton, const std::vector<std::uint32_t>& bones) {
  std::vector<Limb> limbs;
  for (const std::string side : {"left", "right"}) {
    const auto add = [&](const char* joint, const char* tip, bool is_upper) {
      const Limb limb{bones[humanoid_bone(side + joint)], bones[humanoid_bone(side + tip)], is_upper};
      if (limb.joint != kNone && limb.tip != kNone && skeleton.parents[limb.tip] == limb.joint) limbs.push_back(limb);
    };
    add("UpperArm", "LowerArm", true);
    add("LowerArm", "Hand", false);
    add("UpperLeg", "LowerLeg", true);
    add("LowerLeg", "Foot", false);
  }
  return limbs;
}

bool says_twist(const std::string& name) {
  const std::vector<std::string> words = name_words(name);
  return std::any_of(words.begin(), words.end(),
                     [](const std::string& word) { return word.find("twist") != std::string::npos || word == "roll"; });
}

/// Nothing for a joint that does not lie along the bone.
std::optional<TwistJoint> twist_joint(const Skeleton& skeleton, const Limb& limb, std::uint32_t joint) {
  constexpr double kBeyond = 0.1, kAside = 0.25;  // tolerances, as fractions of the bone's length
  const Vec3<double> bone = rest_transform(skeleton, limb.tip).translation,
                     place = rest_transform(skeleton, joint).translation;
  const double length = safe_length(bone);
  if (!(length > 0.0)) return std::nullopt;
  TwistJoint twist;
  twist.axis = bone / length;
  const double along = glm::dot(place, twist.axis) / length;
  if (along < -kBeyond || along > 1.0 + kBeyond) return std::nullopt;
  if (safe_length(place - twist.axis * (along * length)) > kAside * length) return std::nullopt;
  twist.joint = joint;
  twist.driver = limb.is_upper ? limb.joint : limb.tip;
  twist.is_below_driver = limb.is_upper;
  twist.share = std::clamp(along, 0.0, 1.0) - (limb.is_upper ? 1.0 : 0.0);
  twist.rest = normalised(rest_transform(skeleton, joint).rotation);
  twist.driver_rest = normalised(rest_transform(skeleton, twist.driver).rotation);
  return twist;
}

}  // namespace

TwistMap make_twist_map(const SkeletonMap& map, const Skeleton& target) {
  TwistMap twists;
  const std::vector<Limb> limbs = limbs_of(target, map.target_bones);
  const auto is_fixed = [&](std::uint32_t j) { return target.fixed_matrix_of[j] != kNone; };
  for (const std::uint32_t joint : map.unmapped_target) {
    const auto limb =
        std::find_if(limbs.begin(), limbs.end(), [&](const Limb& l) { return target.parents[joint] == l.joint; });
    if (limb == limbs.end() || is_fixed(joint) || !says_twist(target.names[joint])) continue;
    const auto twist = twist_joint(target, *limb, joint);
    if (twist && !is_fixed(twist->driver)) twists.joints.push_back(*twist);
  }
  return twists;
}

}  // namespace sinew
