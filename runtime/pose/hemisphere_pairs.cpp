// SPDX-License-Identifier: MIT
#include "runtime/pose/hemisphere_pairs.h"

#include <algorithm>
#include <numeric>

namespace sinew {
namespace {

constexpr std::size_t kMaxJoints = 4096;     ///< limit for the table of all pairs of joints
constexpr std::size_t kMaxEntries = 65'536;  ///< number of joints that 16-bit indices can name

}  // namespace

std::vector<JointPair> hemisphere_edges(const Skeleton& skeleton, const Skin& skin) {
  if (skin.joints.size() > kMaxEntries) return {};
  std::vector<std::uint32_t> entry_of(skeleton.joint_count(), kNone);
  std::vector<std::uint16_t> order(skin.joints.size());
  std::iota(order.begin(), order.end(), std::uint16_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint16_t a, std::uint16_t b) { return skin.joints[a] < skin.joints[b]; });
  std::vector<JointPair> edges;
  for (const std::uint16_t entry : order) {
    const std::uint32_t joint = skin.joints[entry];
    std::uint32_t above = entry_of[joint] != kNone ? joint : skeleton.parents[joint];  // a skin may list a joint twice
    while (above != kNone && entry_of[above] == kNone) above = skeleton.parents[above];
    if (above != kNone) edges.push_back({static_cast<std::uint16_t>(entry_of[above]), entry});
    if (entry_of[joint] == kNone) entry_of[joint] = entry;
  }
  return edges;
}

std::vector<JointPair> joint_pairs_of_vertices(const VertexInfluences& influences, std::size_t joint_count) {
  if (joint_count > kMaxJoints) return {};
  std::vector<bool> seen(joint_count * joint_count, false);
  std::vector<JointPair> pairs;
  std::size_t vertices = 0;
  for (const InfluenceGroup& group : influences.groups) {
    vertices += group.vertex_count;
    for (std::size_t v = 0; v < group.vertex_count; ++v) {
      const std::uint16_t* joints = &influences.joints[group.first_influence + v * group.influence_count];
      for (std::uint32_t i = 1; i < group.influence_count; ++i) {
        const std::size_t at = joints[0] * joint_count + joints[i];
        if (!seen[at]) pairs.push_back({joints[0], joints[i]});
        seen[at] = true;
      }
    }
  }
  return pairs.size() < vertices ? pairs : std::vector<JointPair>{};
}

}  // namespace sinew
