// SPDX-License-Identifier: MIT
#include "importer/vrm_springs.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "importer/visible_text.h"
#include "runtime/procedures/springs/springs.h"

namespace sinew {
namespace {

constexpr double kEndOfVrm0_m = 0.07;

class SetupMaker {
 public:
  SetupMaker(const VrmCharacter& vrm, const Skeleton& skeleton, VrmSprings& out)
      : vrm_(vrm), skeleton_(skeleton), out_(out), swings_(skeleton.joint_count(), false) {}

  void make() {
    for (std::size_t c = 0; c < vrm_.colliders.size(); ++c) add_collider(c);
    for (std::size_t s = 0; s < vrm_.springs.size(); ++s) add_spring(s);
  }

 private:
  void leave_out(const char* list, std::size_t index, const std::string& why) {
    out_.left_out.push_back(std::string(list) + '[' + std::to_string(index) + "]: " + why);
  }

  void add_collider(std::size_t index) {
    const VrmCollider& from = vrm_.colliders[index];
    collider_of_.push_back(kNone);
    if (from.joint == kNone) return leave_out("colliders", index, "it names no node");
    constexpr std::pair<VrmCollider::Kind, SpringCollider::Kind> kKinds[] = {
        {VrmCollider::Kind::sphere, SpringCollider::Kind::sphere},
        {VrmCollider::Kind::capsule, SpringCollider::Kind::capsule},
        {VrmCollider::Kind::plane, SpringCollider::Kind::plane}};
    SpringCollider& to = out_.setup.colliders.emplace_back();
    for (const auto& [vrm, kind] : kKinds)
      if (from.kind == vrm) to.kind = kind;
    to.joint = from.joint;
    to.offset = Vec3<double>(from.offset_m);
    to.tail = Vec3<double>(from.tail_m);
    to.normal = Vec3<double>(from.normal);
    to.radius_m = static_cast<double>(from.radius_m);
    to.inside = from.inside;
    collider_of_.back() = static_cast<std::uint32_t>(out_.setup.colliders.size() - 1);
  }

  void add_spring(std::size_t index) {
    const VrmSpring& spring = vrm_.springs[index];
    const auto group_index = static_cast<std::uint32_t>(out_.setup.groups.size());
    SpringGroup& group = out_.setup.groups.emplace_back();
    group.center = spring.center;
    for (const std::uint32_t c : spring.colliders)
      if (collider_of_[c] != kNone) group.colliders.push_back(collider_of_[c]);
    const std::size_t first = out_.setup.joints.size();
    if (vrm_.version.starts_with('0')) {
      for (const VrmSpringJoint& root : spring.joints)
        add_chain_below(skeleton_, root.joint, joint_from(root, group_index), kEndOfVrm0_m, out_.setup);
    } else {
      for (std::size_t j = 0; j + 1 < spring.joints.size(); ++j) {
        SpringJoint joint = joint_from(spring.joints[j], group_index);
        if (const auto tail = place_in(spring.joints[j + 1].joint, joint.joint)) {
          joint.tail_m = *tail;
          out_.setup.joints.push_back(joint);
        } else {
          leave_out("springs", index, "joint " + name_of(joint.joint) + " is not above the next one");
        }
      }
    }
    keep_usable(index, first);
  }

  /// Of the joints from `first` on, drops each that another spring already moves, or whose matrix is fixed.
  void keep_usable(std::size_t spring, std::size_t first) {
    auto& joints = out_.setup.joints;
    const auto refuses = [&](const SpringJoint& joint) {
      const bool is_fixed = skeleton_.fixed_matrix_of[joint.joint] != kNone, is_second = swings_[joint.joint];
      if (is_fixed || is_second)
        leave_out("springs", spring,
                  "joint " + name_of(joint.joint) +
                      (is_fixed ? " has a matrix in place of a rotation" : " has a spring already"));
      swings_[joint.joint] = true;
      return is_fixed || is_second;
    };
    std::vector<SpringJoint> kept;
    for (std::size_t j = first; j < joints.size(); ++j)
      if (!refuses(joints[j])) kept.push_back(joints[j]);
    joints.resize(first);
    joints.insert(joints.end(), kept.begin(), kept.end());
  }

  static SpringJoint joint_from(const VrmSpringJoint& from, std::uint32_t group) {
    SpringJoint joint;
    joint.joint = from.joint;
    joint.group = group;
    joint.stiffness = static_cast<double>(from.stiffness);
    joint.drag = std::clamp(static_cast<double>(from.drag_force), 0.0, 1.0);
    joint.gravity_m_s = Vec3<double>(from.gravity_direction) * static_cast<double>(from.gravity_power);
    joint.lagging_length = true;
    joint.hit_radius_m = (std::max)(static_cast<double>(from.hit_radius_m), 0.0);
    return joint;
  }

  /// Rest position of `joint` in the space of its ancestor `above`; nothing if `above` is no ancestor.
  std::optional<Vec3<double>> place_in(std::uint32_t joint, std::uint32_t above) const {
    Vec3<double> place(0.0);
    for (; joint != above; joint = skeleton_.parents[joint]) {
      if (joint == kNone) return std::nullopt;
      const std::uint32_t fixed = skeleton_.fixed_matrix_of[joint];
      const Affined local = fixed != kNone ? affine_cast<double>(skeleton_.fixed_matrices[fixed])
                                           : affine_cast<double>(affine_from_transform(skeleton_.rest[joint]));
      place = transform_point(local, place);
    }
    return place;
  }

  std::string name_of(std::uint32_t joint) const { return '"' + visible_text(skeleton_.names[joint]) + '"'; }

  const VrmCharacter& vrm_;
  const Skeleton& skeleton_;
  VrmSprings& out_;
  std::vector<bool> swings_;                ///< [joints]
  std::vector<std::uint32_t> collider_of_;  ///< [colliders of the file] index in the setup; kNone = left out
};

}  // namespace

VrmSprings spring_setup_of(const VrmCharacter& vrm, const Skeleton& skeleton) {
  VrmSprings out;
  SetupMaker(vrm, skeleton, out).make();
  return out;
}

std::vector<NodeConstraint> node_constraints_of(const VrmCharacter& vrm) {
  using From = VrmConstraint::Kind;
  using To = NodeConstraint::Kind;
  std::vector<NodeConstraint> out;
  for (const VrmConstraint& from : vrm.constraints) {
    const To kind = from.kind == From::roll ? To::roll : from.kind == From::aim ? To::aim : To::rotation;
    out.push_back({kind, from.joint, from.source, Vec3<double>(from.axis), static_cast<double>(from.weight)});
  }
  return out;
}

}  // namespace sinew
