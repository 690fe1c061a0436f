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

  const aiNode* node = nullptr;           ///< The end of the chain; it has the name and the meshes.
  std::size_t parent = kNoParent;         ///< Before its children.
  std::vector<const aiNode*> links;       ///< From the parent inward; `node` is the last.
  std::vector<const aiNode*> mesh_links;  ///< Places the meshes below the joint, and nothing else.
};

/// Folds the chains below `root`, which becomes joint 0.
std::vector<FoldedJoint> fold_joints(const aiNode& root);

/// The node channels of an animation, by the name of their node.
using Channels = std::map<std::string_view, const aiNodeAnim*>;
Channels channels_of(const aiAnimation& animation);

/// The channel that gives the whole transform of a joint; null if there is none. assimp writes such a channel also for
/// a chain whose parts are only translation, rotations and scale.
const aiNodeAnim* whole_channel(const FoldedJoint& joint, const Channels& channels);

/// True if a channel moves any link of the joint.
bool is_animated(const FoldedJoint& joint, const Channels& channels);

Affined matrix_of(const aiMatrix4x4& m) noexcept;

/// Product of the matrices of nodes.
Affined product_of(const std::vector<const aiNode*>& links) noexcept;

/// Keys before and after a time, and how far the time is between them.
template <class Key>
struct KeysAround {
  const Key *before, *after;
  double factor;  ///< 0 = at `before`, or outside of all keys
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

/// A channel at a time in ticks: linear between keys, held outside of them.
Transformd sample_channel(const aiNodeAnim& channel, double ticks) noexcept;

/// The joint's transform in its parent's space at a time in ticks.
Affined local_at(const FoldedJoint& joint, const Channels& channels, double ticks) noexcept;

}  // namespace sinew::formats
