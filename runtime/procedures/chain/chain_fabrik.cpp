// SPDX-License-Identifier: MIT
#include "runtime/math/rotation_between.h"
#include "runtime/procedures/chain/best_rotation.h"
#include "runtime/procedures/chain/chain_tree.h"

namespace sinew::ik {
namespace {

using V = Vec3<double>;

/// True if fabrik places this node: a moving joint or an effector.
bool is_point(const ChainTree& tree, std::uint32_t node) noexcept {
  if (tree.nodes[node].part != kNone) return true;
  for (const std::uint32_t effector : tree.effectors)
    if (effector == node) return true;
  return false;
}

/// The nearest moving joint above a point, or kNone.
std::uint32_t point_above(const ChainTree& tree, std::uint32_t node) noexcept {
  std::uint32_t above = tree.nodes[node].parent;
  while (above != kNone && tree.nodes[above].part == kNone) above = tree.nodes[above].parent;
  return above;
}

/// The place at distance `length` from `end`, in the direction of `at`.
V at_length(const V& end, const V& at, double length, const V& fallback) noexcept {
  return end + normalised_or(at - end, fallback) * length;
}

/// Weighted mean of the places that a point's target and the points below it ask for.
struct Pull {
  V sum{0.0};
  double weights = 0.0;
  void add(const V& place, double weight) noexcept {
    sum += place * weight;
    weights += weight;
  }
};

Pull own_target(const ChainTree& tree, std::uint32_t node) noexcept {
  Pull pull;
  for (std::size_t i = 0; i < tree.effectors.size(); ++i)
    if (tree.effectors[i] == node)
      pull.add(tree.goal().effectors[i].target, static_cast<double>(tree.goal().effectors[i].weight));
  return pull;
}

/// Weight of all effectors at and below a point.
double weight_below(const ChainTree& tree, std::uint32_t node) noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < tree.effectors.size(); ++i)
    if ((tree.nodes[node].effectors >> i & 1) != 0) sum += static_cast<double>(tree.goal().effectors[i].weight);
  return sum;
}

void draw_to_targets(ChainTree& tree) noexcept {
  for (std::uint32_t n = static_cast<std::uint32_t>(tree.nodes.size()); n-- > 0;) {
    if (!is_point(tree, n)) continue;
    Pull pull = own_target(tree, n);
    if (tree.nodes[n].part != kNone)
      for (std::uint32_t child = n + 1; child < tree.nodes.size(); ++child) {
        if (!is_point(tree, child) || point_above(tree, child) != n) continue;
        const V bone = tree.place(n) - tree.place(child);
        const double length = safe_length(bone);
        pull.add(at_length(tree.points[child], tree.points[n], length, normalised_or(bone, V(0.0))),
                 weight_below(tree, child));
      }
    if (pull.weights > 0.0) tree.points[n] = pull.sum / pull.weights;
  }
}

void draw_back(ChainTree& tree) noexcept {
  for (std::uint32_t n = 0; n < tree.nodes.size(); ++n) {
    if (!is_point(tree, n)) continue;
    const std::uint32_t above = point_above(tree, n);
    if (above == kNone) {
      if (tree.nodes[n].part == kNone || !tree.part(tree.nodes[n]).moves) tree.points[n] = tree.place(n);
      continue;
    }
    const V bone = tree.place(n) - tree.place(above);
    tree.points[n] = at_length(tree.points[above], tree.points[n], safe_length(bone), normalised_or(bone, V(0.0)));
  }
}

/// Turns joints, parents first, so that the joints below come to their computed points.
void turn_to_points(ChainTree& tree) noexcept {
  for (const std::uint32_t at : tree.moving) {
    ChainNode& node = tree.nodes[at];
    const auto back = inverse_of(tree.model_above(node));
    if (!back) continue;
    if (tree.part(node).moves) {
      node.local.translation = transform_point(*back, tree.points[at]);
      tree.update(at);
    }
    BestRotation best;
    V from(0.0), to(0.0);
    int count = 0;
    for (std::uint32_t child = at + 1; child < tree.nodes.size(); ++child) {
      if (!is_point(tree, child) || point_above(tree, child) != at) continue;
      from = transform_point(*back, tree.place(child)) - node.local.translation;
      to = transform_point(*back, tree.points[child]) - node.local.translation;
      best.add(from, to, weight_below(tree, child));
      ++count;
    }
    const Quat<double> above = tree.rotation_above(node);
    bool rotations = false;
    for (std::size_t i = 0; i < tree.effectors.size(); ++i) {
      const ChainEffector& asked = tree.goal().effectors[i];
      if (asked.rotation_weight == 0.0f) continue;
      if (tree.effectors[i] != at &&
          (tree.nodes[tree.effectors[i]].part != kNone || point_above(tree, tree.effectors[i]) != at))
        continue;
      const double length = 0.3 * safe_length(from) + 1e-3 * tree.length;
      best.add(normalised(quat_conjugate(above) * tree.error(i).turn * above),
               static_cast<double>(asked.rotation_weight) * length * length);
      rotations = true;
    }
    if (count == 1 && !rotations)
      tree.turn(at, rotation_between(from, to));
    else if (count > 0 || rotations)
      tree.turn(at, best.rotation());
    tree.update(at);
  }
}

}  // namespace

void step_fabrik(ChainTree& tree) noexcept {
  for (std::uint32_t n = 0; n < tree.nodes.size(); ++n) tree.points[n] = tree.place(n);
  draw_to_targets(tree);
  draw_back(tree);
  turn_to_points(tree);
}

}  // namespace sinew::ik
