// SPDX-License-Identifier: MIT
#include "runtime/retarget/skeleton_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "runtime/base/contract.h"
#include "runtime/math/matrix_rotation.h"
#include "runtime/math/rotation_between.h"
#include "runtime/retarget/rest_transform.h"

namespace sinew {
namespace {

using Quatd = Quat<double>;
using Vec3d = Vec3<double>;

/// A reference pose in model space.
struct ModelPose {
  std::vector<Transformd> local;
  std::vector<Quatd> rotation;
  std::vector<Affined> model;

  ModelPose(const Skeleton& skeleton, std::span<const Transform> reference) {
    for (std::uint32_t j = 0; j < skeleton.joint_count(); ++j) {
      const std::uint32_t parent = skeleton.parents[j];
      Transformd own = reference_transform(skeleton, reference, j);
      own.rotation = normalised(own.rotation);
      local.push_back(own);
      rotation.push_back(parent == kNone ? own.rotation : normalised(rotation[parent] * own.rotation));
      const Affined matrix = affine_from_transform(own);
      model.push_back(parent == kNone ? matrix : model[parent] * matrix);
    }
  }
  Quatd rotation_of(std::uint32_t j) const { return j == kNone ? quat_identity<double>() : rotation[j]; }
  Vec3d place(std::uint32_t j) const { return translation_of(model[j]); }
  /// The factor from lengths in the space of a joint to lengths in model space.
  double scale_of(std::uint32_t j) const {
    const double volume = j == kNone ? 1.0 : std::abs(determinant(model[j]));
    return volume > 0.0 ? std::cbrt(volume) : 1.0;
  }
  Vec3d place_relative_to(std::uint32_t above, std::uint32_t j) const {
    if (above == kNone) return place(j);
    return glm::inverse(linear_part(model[above])) * (place(j) - place(above));
  }
};

/// The mean angle between mapped bones; 0 if no mapped joint has a mapped ancestor.
double mean_bone_angle(const SkeletonMap& map, const ModelPose& from, const ModelPose& to) noexcept {
  double sum = 0.0, count = 0.0;
  for (const MappedJoint& joint : map.joints) {
    if (joint.above_target == kNone || joint.above_source == kNone) continue;
    const Vec3d a = from.place(joint.source) - from.place(joint.above_source),
                b = to.place(joint.target) - to.place(joint.above_target);
    if (!(safe_length(a) > 0.0) || !(safe_length(b) > 0.0)) continue;
    sum += rotation_angle_between(quat_identity<double>(), rotation_between(a, b));
    count += 1.0;
  }
  return count > 0.0 ? sum / count : 0.0;
}

using Pairs = std::vector<std::array<std::uint32_t, 2>>;  // {source, target}

/// Joints whose name occurs exactly once in each skeleton.
Pairs pairs_by_names(const Skeleton& source, const Skeleton& target) {
  std::map<std::string, std::array<std::vector<std::uint32_t>, 2>> places;
  for (std::uint32_t j = 0; j < source.joint_count(); ++j) places[source.names[j]][0].push_back(j);
  for (std::uint32_t j = 0; j < target.joint_count(); ++j) places[target.names[j]][1].push_back(j);
  Pairs pairs;
  for (const auto& [name, at] : places)
    if (!name.empty() && at[0].size() == 1 && at[1].size() == 1) pairs.push_back({at[0][0], at[1][0]});
  return pairs;
}

/// All joints, mapped to themselves, if both skeletons are the same.
Pairs pairs_of_one(const Skeleton& source, const Skeleton& target) {
  Pairs pairs;
  if (source.parents != target.parents || source.names != target.names) return pairs;
  for (std::uint32_t j = 0; j < source.joint_count(); ++j) pairs.push_back({j, j});
  return pairs;
}

Pairs pairs_by_bones(std::span<const std::uint32_t> source, std::span<const std::uint32_t> target) {
  Pairs pairs;
  for (std::size_t b = 0; b < source.size(); ++b)
    if (source[b] != kNone && target[b] != kNone) pairs.push_back({source[b], target[b]});
  return pairs;
}

/// Pairs the root joints above the hips, if both skeletons have one. If only the source has one, its motion is part of
/// the hips' motion, which is then relative to model space.
void add_roots(const Skeleton& source, std::span<const std::uint32_t> source_bones, const Skeleton& target,
               std::span<const std::uint32_t> target_bones, Pairs& pairs) {
  const std::uint32_t hips = humanoid_bone("hips"), from = find_root_joint(source, source_bones[hips]),
                      to = find_root_joint(target, target_bones[hips]);
  if (from != kNone && to != kNone) pairs.push_back({from, to});
}

/// R of the equation of make_skeleton_map for bones of arms and legs; the identity for all other joints.
std::vector<Quatd> limb_turns(const Pairs& bones, const ModelPose& from, const ModelPose& to,
                              std::span<const std::uint32_t> source, std::span<const std::uint32_t> target) {
  std::vector<Quatd> turns(to.local.size(), quat_identity<double>());
  if (bones.empty()) return turns;
  const auto turn = [&](const std::string& bone, const std::string& tip) {
    const std::uint32_t b = humanoid_bone(bone), t = humanoid_bone(tip);
    for (const std::uint32_t joint : {source[b], source[t], target[b], target[t]})
      if (joint == kNone) return;
    turns[target[b]] =
        rotation_between(to.place(target[t]) - to.place(target[b]), from.place(source[t]) - from.place(source[b]));
  };
  for (const std::string side : {"left", "right"}) {
    turn(side + "UpperArm", side + "LowerArm");
    turn(side + "LowerArm", side + "Hand");
    turn(side + "UpperLeg", side + "LowerLeg");
    turn(side + "LowerLeg", side + "Foot");
    const std::uint32_t lower = target[humanoid_bone(side + "LowerArm")];
    for (std::size_t b = 0; b < kHumanoidBones.size() && lower != kNone; ++b) {
      const bool is_hand = kHumanoidBones[b] == side + "Hand";
      const bool is_finger = kHumanoidBones[b].starts_with(side) && b >= humanoid_bone("leftThumbMetacarpal");
      if ((is_hand || is_finger) && target[b] != kNone) turns[target[b]] = turns[lower];
    }
  }
  return turns;
}

/// Rounds components that are almost 0 or 1, so that the identity map keeps keys unchanged.
Quatd without_rounding(const Quatd& q) noexcept {
  constexpr double kRounding = 1e-12;
  const Quatd positive = q.w < 0.0 ? -q : q;
  return std::abs(positive.w - 1.0) <= kRounding && safe_length(Vec3d(q.x, q.y, q.z)) <= kRounding
             ? quat_identity<double>()
             : q;
}

/// The rule of each joint of the target: its own, or that of its parent.
std::vector<TranslationRule> rules_of_joints(const Skeleton& target, const SkeletonMapOptions& options) {
  std::vector<TranslationRule> rules;
  for (const std::uint32_t parent : target.parents) {
    rules.push_back(parent == kNone ? options.translations : rules[parent]);
    for (const ChainRule& chain : options.chains)
      if (chain.joint + 1 == rules.size()) rules.back() = chain.rule;
  }
  return rules;
}

double ratio_of(double source, double target) noexcept { return source > 0.0 && target > 0.0 ? target / source : 1.0; }

/// Makes the map from pairs.
class Mapping {
 public:
  Mapping(const Skeleton& source, const Skeleton& target, const ModelPose& from, const ModelPose& to,
          std::vector<Quatd> turns, const SkeletonMapOptions& options)
      : source_(source),
        target_(target),
        from_(from),
        to_(to),
        turns_(std::move(turns)),
        rules_(rules_of_joints(target, options)) {}

  /// in   hips  of the target; kNone = not known
  SkeletonMap map(Pairs pairs, bool by_names, std::uint32_t hips) {
    map_.by_names = by_names;
    for (std::uint32_t j = hips; j != kNone; j = target_.parents[j]) carries_path_[j] = true;
    std::sort(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) { return a[1] < b[1]; });
    source_of_.assign(target_.joint_count(), kNone);
    for (const auto& [s, t] : pairs) {
      lowest_source_ = std::min(lowest_source_, from_.place(s).y);
      lowest_target_ = std::min(lowest_target_, to_.place(t).y);
    }
    for (const auto& [s, t] : pairs)
      if (t == hips) path_ratio_ = ratio_of_heights(s, t);
    for (const auto& [s, t] : pairs) add(s, t);
    std::vector<bool> used(source_.joint_count());
    for (const MappedJoint& joint : map_.joints) used[joint.source] = true;
    for (std::uint32_t j = 0; j < used.size(); ++j)
      if (!used[j]) map_.unmapped_source.push_back(j);
    for (std::uint32_t j = 0; j < source_of_.size(); ++j)
      if (source_of_[j] == kNone) map_.unmapped_target.push_back(j);
    return std::move(map_);
  }

 private:
  std::uint32_t mapped_above(std::uint32_t t) const noexcept {
    do t = target_.parents[t];
    while (t != kNone && source_of_[t] == kNone);
    return t;
  }
  bool is_above(std::uint32_t above, std::uint32_t j) const noexcept {
    if (above == kNone) return true;
    do j = source_.parents[j];
    while (j != kNone && j != above);
    return j == above;
  }

  void add(std::uint32_t s, std::uint32_t t) {
    MappedJoint joint{t, s, mapped_above(t)};
    joint.above_source = joint.above_target == kNone ? kNone : source_of_[joint.above_target];
    if (!is_above(joint.above_source, s)) return;
    source_of_[t] = s;
    const std::uint32_t parent = target_.parents[t], m = joint.above_target;
    const Quatd above_turned = m == kNone ? quat_identity<double>() : normalised(turns_[m] * to_.rotation[m]);
    joint.before = without_rounding(normalised(quat_conjugate(to_.rotation_of(parent)) * to_.rotation_of(m) *
                                               quat_conjugate(above_turned) * from_.rotation_of(joint.above_source)));
    joint.after = without_rounding(normalised(quat_conjugate(from_.rotation[s]) * turns_[t] * to_.rotation[t]));
    set_translation(joint);
    map_.joints.push_back(joint);
  }

  void set_translation(MappedJoint& joint) {
    const std::uint32_t parent = target_.parents[joint.target];
    const bool is_child = source_.parents[joint.source] == joint.above_source;
    joint.source_place =
        is_child ? from_.local[joint.source].translation : from_.place_relative_to(joint.above_source, joint.source);
    const TranslationRule rule = rules_[joint.target];
    const bool is_path = joint.above_target == kNone || carries_path_[joint.target];
    joint.moves =
        rule == TranslationRule::by_length || (rule == TranslationRule::hips_by_height && (is_path || map_.by_names));
    if (is_path) map_.height_ratio = path_ratio_ > 0.0 ? path_ratio_ : ratio_of_heights(joint.source, joint.target);
    const bool by_height = is_path && rule != TranslationRule::by_length;
    const double ratio =
        by_height ? map_.height_ratio * from_.scale_of(joint.above_source) / to_.scale_of(parent)
                  : ratio_of(safe_length(joint.source_place), safe_length(to_.local[joint.target].translation));
    joint.translation = matrix_from_unit_quat(joint.before) * ratio;
  }

  double ratio_of_heights(std::uint32_t s, std::uint32_t t) const {
    return ratio_of(from_.place(s).y - lowest_source_, to_.place(t).y - lowest_target_);
  }

  const Skeleton &source_, &target_;
  const ModelPose &from_, &to_;
  std::vector<Quatd> turns_;  // [target joints] R
  std::vector<std::uint32_t> source_of_;
  double lowest_source_ = std::numeric_limits<double>::infinity();  // height of the lowest mapped joint
  double lowest_target_ = lowest_source_;
  std::vector<TranslationRule> rules_;                                         // [target joints]
  std::vector<bool> carries_path_ = std::vector<bool>(target_.joint_count());  // the hips and their ancestors
  double path_ratio_ = 0.0;  // ratio of the hip heights; 0 = not known
  SkeletonMap map_;
};

}  // namespace

ErrorCode check(const SkeletonMapOptions& options, const Skeleton& source, const Skeleton& target) {
  for (const auto* bones : {&options.source_bones, &options.target_bones})
    if (!bones->empty() && bones->size() != kHumanoidBones.size()) return ErrorCode::size_mismatch;
  const auto fits = [](std::span<const Transform> pose, const Skeleton& skeleton) {
    return pose.empty() || pose.size() == skeleton.joint_count();
  };
  if (!fits(options.source_reference, source) || !fits(options.target_reference, target))
    return ErrorCode::size_mismatch;
  std::vector<bool> is_mapped(target.joint_count()), has_rule(target.joint_count());
  for (const auto& [from, to] : options.pairs) {
    if (from >= source.joint_count() || to >= target.joint_count()) return ErrorCode::index_out_of_range;
    if (is_mapped[to]) return ErrorCode::unsupported;
    is_mapped[to] = true;
  }
  for (const ChainRule& chain : options.chains) {
    if (chain.joint >= target.joint_count()) return ErrorCode::index_out_of_range;
    if (has_rule[chain.joint]) return ErrorCode::unsupported;
    has_rule[chain.joint] = true;
  }
  return ErrorCode::ok;
}

SkeletonMap make_skeleton_map(const Skeleton& source, const Skeleton& target, const SkeletonMapOptions& options) {
  CONTRACT(check(options, source, target) == ErrorCode::ok && "options of a map are of its skeletons");
  const ModelPose from(source, options.source_reference), to(target, options.target_reference);
  const auto bones_of = [](const Skeleton& skeleton, const std::vector<std::uint32_t>& given) {
    return given.empty() ? find_humanoid_bones(skeleton) : given;
  };
  const std::vector<std::uint32_t> source_bones = bones_of(source, options.source_bones),
                                   target_bones = bones_of(target, options.target_bones);
  Pairs by_names = pairs_of_one(source, target);
  const bool is_one = !by_names.empty();
  if (!is_one) by_names = pairs_by_names(source, target);
  Pairs by_bones = pairs_by_bones(source_bones, target_bones);
  if (!by_bones.empty()) add_roots(source, source_bones, target, target_bones, by_bones);
  const bool said = !options.source_bones.empty() || !options.target_bones.empty();
  const bool more_names = said ? by_names.size() > by_bones.size() : by_names.size() >= by_bones.size();
  const bool names = options.pairs.empty() && (is_one || more_names);
  const bool turns = !names && options.limbs == LimbDirections::of_source;
  Mapping mapping(source, target, from, to,
                  limb_turns(turns ? by_bones : Pairs{}, from, to, source_bones, target_bones), options);
  SkeletonMap map = mapping.map(!options.pairs.empty() ? options.pairs
                                : names                ? by_names
                                                       : by_bones,
                                names, target_bones[humanoid_bone("hips")]);
  map.target_bones = target_bones;
  if (!is_rest_pose(source, options.source_reference)) {
    map.source_reference = PoseReference::given;
    map.source_pose.assign(options.source_reference.begin(), options.source_reference.end());
  }
  if (!is_rest_pose(target, options.target_reference)) {
    map.target_reference = PoseReference::given;
    map.target_pose.assign(options.target_reference.begin(), options.target_reference.end());
  }
  map.bone_angle_rad = mean_bone_angle(map, from, to);
  return map;
}

}  // namespace sinew
