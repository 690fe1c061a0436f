// SPDX-License-Identifier: MIT
#include "importer/tool/left_out_joints.h"

#include <fmt/core.h>

#include "importer/tool/length_text.h"
#include "runtime/plan/plan_assets.h"

namespace sinew::tool {
namespace {

/// A joint's name, or the number of its node if it has no name.
std::string name_of(const Skeleton& skeleton, std::uint32_t joint) {
  return skeleton.names[joint].empty() ? fmt::format("node {}", skeleton.node_of_joint[joint]) : skeleton.names[joint];
}

/// [J] for each left-out joint below a kept one: the number of joints in its branch, itself included; 0 for all others.
std::vector<std::uint32_t> branch_sizes(const Skeleton& skeleton, const std::vector<JointMapping>& map) {
  std::vector<std::uint32_t> sizes(map.size(), 0), top(map.size());
  for (std::uint32_t j = 0; j < map.size(); ++j) {
    if (map[j].is_kept) continue;
    const std::uint32_t parent = skeleton.parents[j];
    top[j] = map[parent].is_kept ? j : top[parent];
    ++sizes[top[j]];
  }
  return sizes;
}

}  // namespace

std::string left_out_text(const Scene& scene, const CompiledSkeletonLod& within) {
  const Skeleton& skeleton = scene.skeleton;
  std::string text = fmt::format("joints left out within {}: {} of {}", length_text(within.tolerance_m),
                                 within.left_out, skeleton.joint_count());
  if (within.left_out == 0) return text + "\n";
  text += fmt::format("; they move vertices by {} at most\n", length_text(within.measured_m));
  const std::vector<JointMapping> map = map_joints(scene, within.detail);
  const std::vector<std::uint32_t> sizes = branch_sizes(skeleton, map);
  for (std::uint32_t j = 0; j < sizes.size(); ++j) {
    if (sizes[j] == 0) continue;
    const std::string more = sizes[j] > 1 ? fmt::format(" and {} below", sizes[j] - 1) : "";
    text += fmt::format("  {}{} on {}\n", name_of(skeleton, j), more, name_of(skeleton, map[j].kept_joint));
  }
  return text;
}

Json left_out_json(const Scene& scene, const CompiledSkeletonLod& within) {
  Json left_out = Json::array();
  const std::vector<JointMapping> map = map_joints(scene, within.detail);
  for (std::uint32_t j = 0; j < map.size(); ++j)
    if (!map[j].is_kept)
      left_out.push_back({{"joint", name_of(scene.skeleton, j)},
                          {"node", scene.skeleton.node_of_joint[j]},
                          {"follows", name_of(scene.skeleton, map[j].kept_joint)}});
  return {{"asked", within.tolerance_m},
          {"measured", within.measured_m},
          {"joints", scene.skeleton.joint_count()},
          {"left_out", left_out}};
}

std::string lod_lines(std::span<const CompiledSkeletonLod> lods, std::size_t joint_count) {
  std::string lines;
  for (const CompiledSkeletonLod& lod : lods)
    lines += fmt::format("skeleton LOD within {}: {} of {} joints left out, measured {}\n",
                         length_text(lod.tolerance_m), lod.left_out, joint_count, length_text(lod.measured_m));
  return lines;
}

}  // namespace sinew::tool
