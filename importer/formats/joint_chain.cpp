// SPDX-License-Identifier: MIT
#include "importer/formats/joint_chain.h"

#include <algorithm>

#include "runtime/math/interpolate.h"

namespace sinew::formats {
namespace {

constexpr std::string_view kMark = "_$AssimpFbx$_";

std::string_view name_of(const aiNode& node) { return {node.mName.data, node.mName.length}; }

/// "PreRotation" of "hip_$AssimpFbx$_PreRotation"; empty for other nodes.
std::string_view part_of_chain(const aiNode& node) {
  const std::string_view name = name_of(node);
  const std::size_t at = name.rfind(kMark);
  return at == name.npos || node.mNumMeshes != 0 ? std::string_view() : name.substr(at + kMark.size());
}

struct Folding {
  std::vector<FoldedJoint> joints;

  void add(const aiNode& node, std::size_t parent, FoldedJoint chain) {
    const std::string_view part = part_of_chain(node);
    std::size_t below = parent;
    if (part.empty()) {
      chain.node = &node;
      chain.parent = parent;
      chain.links.push_back(&node);
      below = joints.size();
      joints.push_back(std::move(chain));
      chain = {};
    } else if (!part.starts_with("Geometric")) {
      chain.links.push_back(&node);
    } else if (!part.ends_with("Inverse")) {  // the inverse takes back what the joint never gets
      chain.mesh_links.push_back(&node);
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) add(*node.mChildren[i], below, chain);
  }
};

Vec3<double> vector_of(const aiVector3D& v) { return {v.x, v.y, v.z}; }
Quat<double> rotation_of(const aiQuaternion& q) {
  const Quat<double> out(q.w, q.x, q.y, q.z);
  const double length = glm::length(out);
  return length > 0.0 ? out / length : Quat<double>(1.0, 0.0, 0.0, 0.0);
}

Vec3<double> sample(const aiVectorKey* keys, unsigned count, double ticks, const Vec3<double>& without) {
  if (count == 0) return without;
  const auto at = keys_around(keys, count, ticks);
  return vector_of(at.before->mValue) * (1.0 - at.factor) + vector_of(at.after->mValue) * at.factor;
}

Quat<double> sample(const aiQuatKey* keys, unsigned count, double ticks) {
  if (count == 0) return {1.0, 0.0, 0.0, 0.0};
  const auto at = keys_around(keys, count, ticks);
  return slerp_short_arc(rotation_of(at.before->mValue), rotation_of(at.after->mValue), at.factor);
}

const aiNodeAnim* find(const Channels& channels, const aiNode& node) {
  const auto at = channels.find(name_of(node));
  return at == channels.end() ? nullptr : at->second;
}

}  // namespace

std::vector<FoldedJoint> fold_joints(const aiNode& root) {
  Folding folding;
  folding.add(root, FoldedJoint::kNoParent, {});
  return std::move(folding.joints);
}

Channels channels_of(const aiAnimation& animation) {
  Channels out;
  for (unsigned i = 0; i < animation.mNumChannels; ++i) {
    const aiNodeAnim& channel = *animation.mChannels[i];
    out.emplace(std::string_view(channel.mNodeName.data, channel.mNodeName.length), &channel);
  }
  return out;
}

const aiNodeAnim* whole_channel(const FoldedJoint& joint, const Channels& channels) {
  return find(channels, *joint.node);
}

bool is_animated(const FoldedJoint& joint, const Channels& channels) {
  return std::any_of(joint.links.begin(), joint.links.end(),
                     [&](const aiNode* link) { return find(channels, *link) != nullptr; });
}

Affined matrix_of(const aiMatrix4x4& m) noexcept {
  Affined out;
  out.row[0] = {m.a1, m.a2, m.a3, m.a4};
  out.row[1] = {m.b1, m.b2, m.b3, m.b4};
  out.row[2] = {m.c1, m.c2, m.c3, m.c4};
  return out;
}

Affined product_of(const std::vector<const aiNode*>& links) noexcept {
  Affined out;
  for (const aiNode* link : links) out = out * matrix_of(link->mTransformation);
  return out;
}

Transformd sample_channel(const aiNodeAnim& channel, double ticks) noexcept {
  Transformd out;
  out.translation = sample(channel.mPositionKeys, channel.mNumPositionKeys, ticks, Vec3<double>(0.0));
  out.rotation = sample(channel.mRotationKeys, channel.mNumRotationKeys, ticks);
  out.scale = sample(channel.mScalingKeys, channel.mNumScalingKeys, ticks, Vec3<double>(1.0));
  return out;
}

Affined local_at(const FoldedJoint& joint, const Channels& channels, double ticks) noexcept {
  if (const aiNodeAnim* whole = whole_channel(joint, channels))
    return affine_from_transform(sample_channel(*whole, ticks));
  Affined out;
  for (const aiNode* link : joint.links) {
    const aiNodeAnim* channel = find(channels, *link);
    out = out * (channel != nullptr ? affine_from_transform(sample_channel(*channel, ticks))
                                    : matrix_of(link->mTransformation));
  }
  return out;
}

}  // namespace sinew::formats
