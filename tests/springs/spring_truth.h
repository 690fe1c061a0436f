// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <vector>

#include "runtime/animation/skeleton.h"
#include "runtime/math/inverse.h"
#include "runtime/math/rotation_between.h"
#include "runtime/procedures/springs/spring_setup.h"

namespace sinew::test {

/// Springs as the text of VRMC_springBone 1.0 has them: one step a frame, all matrices composed anew for each joint.
/// It is slow, holds no state but the tails, and shares no code with SpringsJob.
class SpringTruth {
 public:
  SpringTruth(const Skeleton& skeleton, SpringSetup setup) : skeleton_(skeleton), setup_(std::move(setup)) {}

  std::vector<Transformd> pose;  ///< [J] local transforms; step() turns the joints of springs
  Affined root;
  std::vector<Vec3<double>> tails;  ///< [joints of the setup] in the world

  void reset() {
    aim_at_goals();
    tails.clear();
    for (const SpringJoint& joint : setup_.joints) tails.push_back(transform_point(world(joint.joint), joint.tail_m));
    now_.clear();
    for (std::size_t j = 0; j < tails.size(); ++j) now_.push_back(transform_point(to_center(j), tails[j]));
    before_ = now_;
    remember_ends();
  }

  /// in  dt_s  length of the step. Each step loses the share `drag` of the velocity, long or short.
  void step(double dt_s) {
    aim_at_goals();
    for (std::uint32_t j = 0; j < skeleton_.joint_count(); ++j)
      for (std::size_t s = 0; s < setup_.joints.size(); ++s)
        if (setup_.joints[s].joint == j) step_joint(s, dt_s);
    remember_ends();
  }

 private:
  void aim_at_goals() {
    for (const SpringJoint& joint : setup_.joints)
      if (setup_.groups[joint.group].goal == SpringGoal::rest)
        pose[joint.joint].rotation = normalised(quat_cast<double>(skeleton_.rest[joint.joint].rotation));
  }

  Affined world(std::uint32_t joint) const {
    Affined m = affine_from_transform(pose[joint]);
    for (std::uint32_t j = skeleton_.parents[joint]; j != kNone; j = skeleton_.parents[j])
      m = affine_from_transform(pose[j]) * m;
    return root * m;
  }

  /// World transform of the joint above the whole chain.
  Affined above_chain(std::size_t s) const {
    std::uint32_t top = setup_.joints[s].joint;
    for (std::uint32_t j = top; j != kNone; j = skeleton_.parents[j])
      for (const SpringJoint& other : setup_.joints)
        if (other.joint == j) top = j;
    return skeleton_.parents[top] == kNone ? root : world(skeleton_.parents[top]);
  }

  /// Keeps the end of each bone in the space of the joint above its chain.
  void remember_ends() {
    ends_.clear();
    for (std::size_t s = 0; s < setup_.joints.size(); ++s) {
      const Vec3<double> end = transform_point(world(setup_.joints[s].joint), setup_.joints[s].tail_m);
      ends_.push_back(transform_point(inverse_of(above_chain(s)).value(), end));
    }
  }

  Affined from_center(std::size_t s) const {
    const std::uint32_t center = setup_.groups[setup_.joints[s].group].center;
    return center == kNone ? Affined{} : world(center);
  }
  Affined to_center(std::size_t s) const { return inverse_of(from_center(s)).value(); }

  void step_joint(std::size_t s, double dt_s) {
    const SpringJoint& joint = setup_.joints[s];
    const Affined goal = world(joint.joint);
    const Vec3<double> head = translation_of(goal), bone = transform_vector(goal, joint.tail_m);
    const double bone_length = glm::length(bone);
    const double length =
        joint.lagging_length ? glm::length(transform_point(above_chain(s), ends_[s]) - head) : bone_length;
    const auto at_length = [&](const Vec3<double>& p) { return head + glm::normalize(p - head) * length; };
    Vec3<double> next = transform_point(from_center(s), now_[s] + (now_[s] - before_[s]) * (1.0 - joint.drag));
    next += glm::normalize(bone) * (joint.stiffness * dt_s) + joint.gravity_m_s * dt_s;
    next = at_length(next);
    for (const std::uint32_t c : setup_.groups[joint.group].colliders) {
      const auto [distance, away] = distance_to(setup_.colliders[c], next, joint.hit_radius_m);
      if (distance < 0.0) next = at_length(next - away * distance);
    }
    before_[s] = now_[s];
    now_[s] = transform_point(to_center(s), next);
    tails[s] = head + glm::normalize(next - head) * bone_length;
    Transformd& local = pose[joint.joint];
    const Vec3<double> axis = local.scale * joint.tail_m;
    Transformd unscaled = local;
    unscaled.scale = Vec3<double>(1.0);
    const std::uint32_t parent = skeleton_.parents[joint.joint];
    const Affined above = parent == kNone ? root : world(parent);
    const Affined to_goal = inverse_of(above * affine_from_transform(unscaled)).value();
    local.rotation = local.rotation * rotation_between(axis, transform_point(to_goal, next));
  }

  struct Hit {
    double distance;
    Vec3<double> away;
  };
  Hit distance_to(const SpringCollider& shape, const Vec3<double>& tail, double hit_radius) const {
    const Affined m = world(shape.joint);
    const Vec3<double> a = transform_point(m, shape.offset);
    if (shape.kind == SpringCollider::Kind::plane) {
      const Mat3<double> normals = glm::transpose(glm::inverse(linear_part(m)));
      const Vec3<double> n = glm::normalize(normals * shape.normal);
      return {glm::dot(tail - a, n) - hit_radius, n};
    }
    Vec3<double> nearest = a;
    if (shape.kind == SpringCollider::Kind::capsule) {
      const Vec3<double> b = transform_point(m, shape.tail);
      nearest += (b - a) * std::clamp(glm::dot(tail - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
    }
    const double far = glm::length(tail - nearest);
    const Vec3<double> out = (tail - nearest) / far;
    return shape.inside ? Hit{shape.radius_m - far - hit_radius, -out} : Hit{far - shape.radius_m - hit_radius, out};
  }

  const Skeleton& skeleton_;
  SpringSetup setup_;
  std::vector<Vec3<double>> ends_;          ///< [joints of the setup] ends of bones, moved along with their chains
  std::vector<Vec3<double>> now_, before_;  ///< [joints of the setup] in the space of their centres
};

}  // namespace sinew::test
