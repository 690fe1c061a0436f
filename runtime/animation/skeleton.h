// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/api.h"
#include "runtime/base/index.h"
#include "runtime/math/transform.h"

namespace sinew {

/// The node hierarchy of a scene. Every node is a *joint*, since glTF puts meshes, cameras and plain nodes between
/// bones; a skin lists the joints that it uses. Joints are in breadth-first order: parents come before children, and
/// the joints of one depth are contiguous.
struct SINEW_API Skeleton {
  std::vector<std::uint32_t> parents;          ///< [J] parents[j] < j, kNone for a root
  std::vector<Transform> rest;                 ///< [J] local transform without a clip; rotations are unit
  std::vector<Affine> fixed_matrices;          ///< local matrices of nodes that have a matrix instead of T, R and S
  std::vector<std::uint32_t> fixed_matrix_of;  ///< [J] index into fixed_matrices, kNone = use `rest`
  std::vector<std::string> names;              ///< [J] may repeat or be empty
  std::vector<std::uint32_t> node_of_joint;    ///< [J] glTF node index
  std::vector<std::uint32_t> joint_of_node;    ///< [J] inverse of node_of_joint
  std::vector<std::uint32_t> level_begin;      ///< [depth + 1] first joint of each depth, last entry = J

  std::size_t joint_count() const noexcept { return parents.size(); }

  /// First joint with that name; nullopt if there is none.    cost O(J)
  std::optional<std::uint32_t> find(std::string_view name) const noexcept;
};

/// A mask for layers that move one limb: `weight` for the joint and all below it, 0 for the other joints
/// (Needs::in.masks).
/// out  [J]     cost O(J), allocates
SINEW_API std::vector<float> mask_below(const Skeleton& skeleton, std::uint32_t joint, float weight = 1.0f);

/// Assigns a joint to a bone of the human body, by the bone's name in VRM 1.0 ("hips", "leftThumbProximal").
struct NamedBone {
  std::string name;
  std::uint32_t joint = kNone;
};

}  // namespace sinew
