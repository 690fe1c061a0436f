// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <assimp/scene.h>

#include "runtime/math/affine.h"
#include "runtime/math/transform.h"

namespace sinew::formats {

/// A joint of the model that is made. assimp writes a joint of FBX as a chain of nodes, one for each part of its
/// transform, called "JOINT_$AssimpFbx$_PreRotation" and the like.
struct FoldedJoint {
  static constexpr std::size_t kNoParent = static_cast<std::size_t>(-1);

  const aiNode* node = nullptr;    ///< Last node of the chain; it bears the joint's name and meshes.
  std::size_t parent = kNoParent;  ///< Index of the parent, always lower than the joint's own; kNoParent for the root.
  std::vector<const aiNode*> links;       ///< From the parent inward; `node` is the last.
  std::vector<const aiNode*> mesh_links;  ///< Places the meshes below the joint, and nothing else.
};

/// Folds the chains below `root`, which becomes joint 0.
std::vector<FoldedJoint> fold_joints(const aiNode& root);

/// The node channels of an animation, by the name of their node.
using Channels = std::map<std::string_view, const aiNodeAnim*>;
Channels channels_of(const aiAnimation& animation);

/// Returns the channel that holds the joint's whole transform, or null. assimp also writes a whole-transform channel
/// for a chain that consists of translation, rotations and scale only.
const aiNodeAnim* whole_channel(const FoldedJoint& joint, const Channels& channels);

/// True if a channel moves any link of the joint.
bool is_animated(const FoldedJoint& joint, const Channels& channels);

Affined matrix_of(const aiMatrix4x4& m) noexcept;

/// Product of the matrices of nodes.
Affined product_of(const std::vector<const aiNode*>& links) noexcept;

/// The two keys around a time, and the time's position between them.
template <class Key>
struct KeysAround {
  const Key *before, *after;
  double factor;  ///< 0 to 1 from `before` to `after`; 0 if the time is outside of all keys.
};

/// in    keys[count]   ascending, at least one
template <class Key>
KeysAround<Key> keys_around(const Key* keys, unsigned count, double ticks) noexcept {
  const Key* const after =
      std::upper_bound(keys, keys + count, ticks, [](double time, const Key& key) { return time < key.mTime; });
  if (after == keys) return {keys, keys, 0.0};
  if (after == keys + count) return {after - 1, after - 1, 0.0};
  return {after - 1, after, (ticks - after[-1].mTime) / (after->mTime - after[-1].mTime)};
}

/// Samples a channel at a time in assimp's ticks. Linear between keys; the first or last key holds outside of them.
Transformd sample_channel(const aiNodeAnim& channel, double ticks) noexcept;

/// The joint's transform in its parent's space at a time in ticks.
Affined local_at(const FoldedJoint& joint, const Channels& channels, double ticks) noexcept;

}  // namespace sinew::formats
