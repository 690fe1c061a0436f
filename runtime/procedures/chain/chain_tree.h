// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "runtime/math/inverse.h"
#include "runtime/procedures/chain_ik.h"

namespace sinew::ik {

/// A copy of the joints between the root of the skeleton and the effectors, in double. Internal to procedures/

/// A joint of the tree. Parents come before their children.
struct ChainNode {
  std::uint32_t joint = 0, parent = kNone;  ///< parent: index of a node, not of a joint
  std::uint32_t part = kNone;               ///< index into ChainGoal::joints; kNone: the joint does not turn
  bool is_fixed = false;                    ///< `matrix` is a fixed matrix of the skeleton and never changes
  std::uint64_t effectors = 0;              ///< bit i: effector i is at or below this joint
  Transformd local;
  Affined matrix, model;
  Quat<double> model_rotation{1.0, 0.0, 0.0, 0.0};
};

/// The remaining error of an effector.
struct ChainError {
  Vec3<double> way{0.0};                  ///< from its place to its target, in model space
  Quat<double> turn{1.0, 0.0, 0.0, 0.0};  ///< in model space, to the wanted rotation; identity if none is wanted
};

/// The largest errors of all effectors, and the weighted sum of their squares.
struct ChainErrors {
  double metres = 0.0, radians = 0.0, cost = 0.0;
};

struct ChainTree {
  const ChainIkJob& job;
  std::span<ChainNode> nodes;
  std::span<std::uint32_t> moving;     ///< [goal.joints] index of the node of each joint
  std::span<std::uint32_t> effectors;  ///< [goal.effectors] index of the node of each effector
  std::span<Transformd> saved;         ///< [goal.joints] backup, for a solver that undoes an iteration
  std::span<JointLimiter> limiters;    ///< [goal.limits]
  std::span<Vec3<double>> points;      ///< [nodes] places that fabrik computes
  std::span<double> numbers;           ///< matrices of `damped`
  double length = 0.0;                 ///< length of the longest chain of bones from a moving joint to an effector

  const ChainGoal& goal() const noexcept { return job.goal; }
  const ChainIkJoint& part(const ChainNode& node) const noexcept { return goal().joints[node.part]; }
  Vec3<double> place(std::uint32_t node) const noexcept { return translation_of(nodes[node].model); }
  Affined model_above(const ChainNode& node) const noexcept {
    return node.parent == kNone ? Affined{} : nodes[node.parent].model;
  }
  Quat<double> rotation_above(const ChainNode& node) const noexcept {
    return node.parent == kNone ? quat_identity<double>() : nodes[node.parent].model_rotation;
  }

  /// Turns a joint in the space of its parent. The turn is clamped to ChainGoal::most_turn_rad and the joint to its
  /// limit.
  void turn(std::uint32_t node, const Quat<double>& by) noexcept;
  /// Recomputes the matrices of the nodes from `first` on.
  void update(std::uint32_t first) noexcept;
  ChainError error(std::size_t effector) const noexcept;
  ChainErrors errors() const noexcept;
};

/// Bytes for all arrays of the tree.
std::size_t chain_bytes(const Skeleton& skeleton, const ChainGoal& goal) noexcept;

/// in   memory  chain_bytes
ChainTree make_chain_tree(const ChainIkJob& job) noexcept;

/// Each function runs one iteration of its solver.
void step_ccd(ChainTree& tree) noexcept;
void step_fabrik(ChainTree& tree) noexcept;
/// in   damping  updated from iteration to iteration; 0 before the first
void step_damped(ChainTree& tree, double& damping) noexcept;

/// Number of doubles that step_damped needs.
std::size_t damped_numbers(std::size_t joints, std::size_t effectors) noexcept;

}  // namespace sinew::ik
