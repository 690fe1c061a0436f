// SPDX-License-Identifier: MIT
#include "runtime/procedures/chain/chain_tree.h"

#include <algorithm>
#include <memory>

#include "runtime/math/axis_angle.h"
#include "runtime/procedures/joint_frames.h"

namespace sinew::ik {
namespace {

/// Takes arrays from a block of memory, each aligned to 64 bytes. Without a block it only counts bytes.
class Block {
 public:
  explicit Block(std::byte* begin) : begin_(begin) {}
  template <class T>
  std::span<T> take(std::size_t count) noexcept {
    T* const at = begin_ != nullptr ? reinterpret_cast<T*>(begin_ + used_) : nullptr;
    used_ += (count * sizeof(T) + 63) / 64 * 64;
    return {at, begin_ != nullptr ? count : 0};
  }
  std::size_t used() const noexcept { return used_; }

 private:
  std::byte* begin_;
  std::size_t used_ = 0;
};

template <class T>
void make_all(std::span<T> items) noexcept {
  std::uninitialized_value_construct(items.begin(), items.end());
}

struct Arrays {
  std::span<std::uint32_t> node_of_joint;
  std::span<ChainNode> nodes;
  std::span<std::uint32_t> moving, effectors;
  std::span<Transformd> saved;
  std::span<JointLimiter> limiters;
  std::span<Vec3<double>> points;
  std::span<double> numbers;

  Arrays(Block& block, std::size_t joint_count, const ChainGoal& goal)
      : node_of_joint(block.take<std::uint32_t>(joint_count)),
        nodes(block.take<ChainNode>(joint_count)),
        moving(block.take<std::uint32_t>(goal.joints.size())),
        effectors(block.take<std::uint32_t>(goal.effectors.size())),
        saved(block.take<Transformd>(goal.joints.size())),
        limiters(block.take<JointLimiter>(goal.limits.size())),
        points(block.take<Vec3<double>>(goal.solver == ChainSolver::fabrik ? joint_count : 0)),
        numbers(block.take<double>(
            goal.solver == ChainSolver::damped ? damped_numbers(goal.joints.size(), goal.effectors.size()) : 0)) {}
};

ChainNode make_node(const ChainIkJob& job, std::uint32_t joint) noexcept {
  ChainNode node;
  node.joint = joint;
  node.local = local_of(job.local, joint);
  node.is_fixed = !can_turn(*job.skeleton, joint);
  node.matrix = local_matrix(*job.skeleton, job.local, joint);
  return node;
}

/// Length of the bones from the uppermost moving joint above an effector to the effector.
double length_to(const ChainTree& tree, std::uint32_t effector) noexcept {
  double length = 0.0, to_moving = 0.0;
  for (std::uint32_t n = effector; n != kNone; n = tree.nodes[n].parent) {
    if (tree.nodes[n].part != kNone) to_moving = length;
    if (tree.nodes[n].parent != kNone) length += safe_length(tree.place(n) - tree.place(tree.nodes[n].parent));
  }
  return to_moving;
}

}  // namespace

void ChainTree::turn(std::uint32_t node, const Quat<double>& by) noexcept {
  ChainNode& at = nodes[node];
  Quat<double> turn = by;
  const double most = static_cast<double>(goal().most_turn_rad);
  if (most > 0.0) {
    const AxisAngleT<double> whole = axis_angle_from_quat(by);
    if (whole.angle_rad > most) turn = quat_from_axis_angle(whole.axis, most);
  }
  at.local.rotation = normalised(turn * at.local.rotation);
  if (part(at).limit != kNone) at.local.rotation = limiters[part(at).limit](at.local.rotation).rotation;
}

void ChainTree::update(std::uint32_t first) noexcept {
  for (std::size_t n = first; n < nodes.size(); ++n) {
    ChainNode& node = nodes[n];
    if (node.part != kNone) node.matrix = affine_from_transform(node.local);
    const bool is_root = node.parent == kNone;
    node.model = is_root ? node.matrix : nodes[node.parent].model * node.matrix;
    node.model_rotation = is_root ? node.local.rotation : nodes[node.parent].model_rotation * node.local.rotation;
  }
}

ChainError ChainTree::error(std::size_t effector) const noexcept {
  const ChainEffector& asked = goal().effectors[effector];
  const ChainNode& node = nodes[effectors[effector]];
  ChainError error;
  if (asked.weight > 0.0f) error.way = asked.target - translation_of(node.model);
  if (asked.rotation_weight > 0.0f)
    error.turn = normalised(quat_cast<double>(asked.rotation)) * quat_conjugate(normalised(node.model_rotation));
  return error;
}

ChainErrors ChainTree::errors() const noexcept {
  ChainErrors all;
  for (std::size_t i = 0; i < effectors.size(); ++i) {
    const ChainError one = error(i);
    const double metres = safe_length(one.way), radians = rotation_angle_between(quat_identity<double>(), one.turn);
    all.metres = std::max(all.metres, metres);
    all.radians = std::max(all.radians, radians);
    all.cost += static_cast<double>(goal().effectors[i].weight) * metres * metres +
                static_cast<double>(goal().effectors[i].rotation_weight) * length * length * radians * radians;
  }
  return all;
}

std::size_t chain_bytes(const Skeleton& skeleton, const ChainGoal& goal) noexcept {
  Block block(nullptr);
  const Arrays arrays(block, skeleton.joint_count(), goal);
  return block.used();
}

ChainTree make_chain_tree(const ChainIkJob& job) noexcept {
  const Skeleton& skeleton = *job.skeleton;
  const ChainGoal& goal = job.goal;
  Block block(job.memory.data());
  const Arrays arrays(block, skeleton.joint_count(), goal);
  std::uninitialized_fill(arrays.node_of_joint.begin(), arrays.node_of_joint.end(), kNone);
  for (std::size_t i = 0; i < goal.limits.size(); ++i) std::construct_at(&arrays.limiters[i], goal.limits[i]);
  constexpr std::uint32_t kWanted = 0;
  for (const ChainEffector& effector : goal.effectors)
    for (std::uint32_t j = effector.joint; j != kNone && arrays.node_of_joint[j] == kNone; j = skeleton.parents[j])
      arrays.node_of_joint[j] = kWanted;
  std::uint32_t count = 0;
  for (std::uint32_t j = 0; j < skeleton.joint_count(); ++j) {
    if (arrays.node_of_joint[j] == kNone) continue;
    std::construct_at(&arrays.nodes[count], make_node(job, j));
    if (skeleton.parents[j] != kNone) arrays.nodes[count].parent = arrays.node_of_joint[skeleton.parents[j]];
    arrays.node_of_joint[j] = count++;
  }
  make_all(arrays.moving);
  make_all(arrays.effectors);
  make_all(arrays.saved);
  make_all(arrays.points);
  make_all(arrays.numbers);
  ChainTree tree{job,          arrays.nodes.first(count), arrays.moving, arrays.effectors,
                 arrays.saved, arrays.limiters,           arrays.points, arrays.numbers};
  for (std::uint32_t i = 0; i < goal.joints.size(); ++i) {
    tree.moving[i] = arrays.node_of_joint[goal.joints[i].joint];
    ChainNode& node = tree.nodes[tree.moving[i]];
    node.part = i;
    node.local.rotation = normalised(node.local.rotation);
    tree.saved[i] = node.local;
  }
  for (std::size_t i = 0; i < goal.effectors.size(); ++i) {
    tree.effectors[i] = arrays.node_of_joint[goal.effectors[i].joint];
    for (std::uint32_t n = tree.effectors[i]; n != kNone; n = tree.nodes[n].parent)
      tree.nodes[n].effectors |= std::uint64_t{1} << i;
  }
  for (ChainNode& node : tree.nodes)
    if (node.is_fixed) node.local.rotation = model_rotation(skeleton, job.local, node.joint);
  for (ChainNode& node : tree.nodes)
    if (node.is_fixed && node.parent != kNone)
      node.local.rotation =
          quat_conjugate(model_rotation(skeleton, job.local, skeleton.parents[node.joint])) * node.local.rotation;
  tree.update(0);
  for (const std::uint32_t effector : tree.effectors) tree.length = std::max(tree.length, length_to(tree, effector));
  return tree;
}

}  // namespace sinew::ik
