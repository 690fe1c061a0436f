// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <numeric>

#include "runtime/animation/skeleton.h"

/// Skeletons of typical shapes, built in code for tests and benchmarks alike.
namespace sinew::scenes {

/// A breadth-first skeleton. In `parents` each parent must come before its children.
inline Skeleton breadth_first(const std::vector<std::uint32_t>& parents, const std::vector<glm::vec3>& offsets) {
  const auto count = static_cast<std::uint32_t>(parents.size());
  std::vector<std::uint32_t> depth(count, 0), order(count), place(count);
  for (std::uint32_t j = 0; j < count; ++j)
    if (parents[j] != kNone) depth[j] = depth[parents[j]] + 1;
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return depth[a] < depth[b]; });
  for (std::uint32_t j = 0; j < count; ++j) place[order[j]] = j;
  Skeleton s;
  for (std::uint32_t j = 0; j < count; ++j) {
    const std::uint32_t source = order[j];
    if (j == 0 || depth[source] > depth[order[j - 1]]) s.level_begin.push_back(j);
    s.parents.push_back(parents[source] == kNone ? kNone : place[parents[source]]);
    s.rest.push_back({offsets[source], Quat<float>(1, 0, 0, 0), glm::vec3(1)});
    s.node_of_joint.push_back(source);
  }
  s.level_begin.push_back(count);
  s.joint_of_node = std::move(place);
  s.names.assign(count, "");
  s.fixed_matrix_of.assign(count, kNone);
  return s;
}

/// A chain: each joint is the parent of the next.
inline Skeleton long_chain(std::uint32_t joint_count) {
  std::vector<std::uint32_t> parents(joint_count, kNone);
  for (std::uint32_t j = 1; j < joint_count; ++j) parents[j] = j - 1;
  return breadth_first(parents, std::vector<glm::vec3>(joint_count, glm::vec3(0, 0.1f, 0)));
}

/// A tree in which each joint has `fan` children.
inline Skeleton wide_tree(std::uint32_t joint_count, std::uint32_t fan = 4) {
  std::vector<std::uint32_t> parents(joint_count, kNone);
  std::vector<glm::vec3> offsets(joint_count, glm::vec3(0));
  for (std::uint32_t j = 1; j < joint_count; ++j) {
    parents[j] = (j - 1) / fan;
    offsets[j] = {0.2f * static_cast<float>((j - 1) % fan) - 0.3f, 0.5f, 0.1f};
  }
  return breadth_first(parents, offsets);
}

/// A biped of 67 joints: spine and head have 8, each leg 5, each arm 4, each hand 5 fingers of 4 joints, and there is a
/// jaw.
inline Skeleton biped() {
  std::vector<std::uint32_t> parents;
  std::vector<glm::vec3> offsets;
  const auto add = [&](std::uint32_t parent, glm::vec3 offset) {
    parents.push_back(parent);
    offsets.push_back(offset);
    return static_cast<std::uint32_t>(parents.size() - 1);
  };
  const auto chain = [&](std::uint32_t parent, glm::vec3 first, glm::vec3 step, int count) {
    std::uint32_t j = add(parent, first);
    for (int i = 1; i < count; ++i) j = add(j, step);
    return j;
  };
  const std::uint32_t hips = add(kNone, {0, 0.95f, 0});
  const std::uint32_t chest = chain(hips, {0, 0.1f, 0}, {0, 0.12f, 0}, 4);
  const std::uint32_t head = chain(chest, {0, 0.2f, 0}, {0, 0.1f, 0}, 3);
  add(head, {0, 0, 0.08f});
  for (const float side : {-1.0f, 1.0f}) {
    chain(hips, {side * 0.1f, -0.05f, 0}, {0, -0.22f, 0.01f}, 5);
    const std::uint32_t hand = chain(chest, {side * 0.08f, 0.15f, 0}, {side * 0.2f, 0, 0}, 4);
    for (int finger = 0; finger < 5; ++finger)
      chain(hand, {side * 0.05f, 0, 0.02f * static_cast<float>(finger - 2)}, {side * 0.03f, 0, 0}, 4);
  }
  return breadth_first(parents, offsets);
}

}  // namespace sinew::scenes
