// SPDX-License-Identifier: MIT
#include "runtime/animation/mirror_animation.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "runtime/animation/constant_tracks.h"
#include "runtime/animation/side_names.h"

namespace sinew {
namespace {

glm::quat mirrored_rotation(const MirroredJoint& joint, const glm::quat& q) noexcept {
  const float in[] = {q.x, q.y, q.z, q.w};
  const auto number = [&](std::size_t row) { return mirrored_number(joint.rotation[row], in); };
  return quat_xyzw(number(0), number(1), number(2), number(3));
}

glm::vec3 mirrored_vector(const std::array<MirrorRow<3>, 3>& rows, const Vec3<double>& offset,
                          const glm::vec3& v) noexcept {
  const float in[] = {v.x, v.y, v.z};
  return {mirrored_number(rows[0], in, offset.x), mirrored_number(rows[1], in, offset.y),
          mirrored_number(rows[2], in, offset.z)};
}

/// True for rows of tangents. They are differences, so the offset is not added to them.
bool is_tangent(Interpolation interpolation, std::size_t row) noexcept {
  return interpolation == Interpolation::cubic_spline && row % 3 != 1;
}

BoneAnimation mirrored_bone(const BoneAnimation& bone, std::uint32_t to, const MirroredJoint& joint) {
  BoneAnimation out = bone;
  out.joint = to;
  for (std::size_t i = 0; i < out.translation.values.size(); ++i) {
    const bool tangent = is_tangent(out.translation.interpolation, i);
    out.translation.values[i] =
        mirrored_vector(joint.translation, tangent ? Vec3<double>(0.0) : joint.offset, bone.translation.values[i]);
  }
  for (glm::quat& q : out.rotation.values) q = mirrored_rotation(joint, q);
  for (glm::vec3& s : out.scale.values) s = mirrored_vector(joint.scale, Vec3<double>(0.0), s);
  return out;
}

/// A copy of `from` with other targets: target i of the result is target `target_of[i]` of `from`.
WeightAnimation picked(const WeightAnimation& from, std::uint32_t first_target,
                       std::span<const std::uint32_t> target_of) {
  const std::size_t old_count = from.weights.target_count, count = target_of.size();
  WeightAnimation out{from.instance, from.weights, first_target};
  out.weights.target_count = static_cast<std::uint32_t>(count);
  out.weights.values.resize(old_count == 0 ? 0 : from.weights.values.size() / old_count * count);
  for (std::size_t i = 0; i < out.weights.values.size(); ++i)
    out.weights.values[i] = from.weights.values[i / count * old_count + target_of[i % count] - from.first_target];
  return out;
}

/// in   partner_of  [targets of the instance] the index of each target's partner
void add_mirrored_weights(const WeightAnimation& from, std::span<const std::uint32_t> partner_of,
                          std::vector<WeightAnimation>& out) {
  const std::uint32_t first = from.first_target, end = first + from.weights.target_count;
  const std::span<const std::uint32_t> partners = partner_of.subspan(first, from.weights.target_count);
  const auto is_inside = [&](std::uint32_t target) { return target >= first && target < end; };
  if (std::all_of(partners.begin(), partners.end(), is_inside)) {
    out.push_back(picked(from, first, partners));
    return;
  }
  for (std::uint32_t target = first; target < end; ++target)
    out.push_back(picked(from, partner_of[target], std::span(&target, 1)));
}

/// Exchanges the names of events and curves on both sides ("left foot", "right foot"), where both exist.
void swap_sides(Annotations& annotations) {
  std::vector<std::string> names = annotations.event_names;
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  std::vector<std::uint32_t> partners = name_partners(names);
  for (std::string& name : annotations.event_names)
    name =
        names[partners[static_cast<std::size_t>(std::lower_bound(names.begin(), names.end(), name) - names.begin())]];
  names.clear();
  for (const NamedCurve& curve : annotations.curves) names.push_back(curve.name);
  partners = name_partners(names);
  for (std::size_t c = 0; c < names.size(); ++c) annotations.curves[c].name = names[partners[c]];
}

}  // namespace

Transform mirrored_transform(const MirrorMap& map, std::uint32_t joint, const Transform& source) noexcept {
  const MirroredJoint& to = map.joints[joint];
  return {mirrored_vector(to.translation, to.offset, source.translation), mirrored_rotation(to, source.rotation),
          mirrored_vector(to.scale, Vec3<double>(0.0), source.scale)};
}

bool is_moved_at_rest(const MirrorMap& map, const Skeleton& skeleton, std::uint32_t joint) noexcept {
  if (map.reference == PoseReference::rest) return false;
  const Transform there = mirrored_transform(map, joint, skeleton.rest[map.joints[joint].source]);
  return skeleton.fixed_matrix_of[joint] == kNone && rest_difference(there, skeleton.rest[joint]).any();
}

Animation mirror_animation(const Animation& animation, const MirrorMap& map, const Skeleton& skeleton,
                           std::span<const std::uint32_t> first_weight) {
  Animation out = animation;
  out.bones.clear();
  swap_sides(out.annotations);
  for (const BoneAnimation& bone : animation.bones) {
    const std::uint32_t to = map.joints[bone.joint].source;  // partners are mutual
    out.bones.push_back(mirrored_bone(bone, to, map.joints[to]));
  }
  if (map.reference != PoseReference::rest) {
    std::vector<Transform> there;
    for (std::uint32_t p = 0; p < map.joints.size(); ++p)
      there.push_back(mirrored_transform(map, p, skeleton.rest[map.joints[p].source]));
    add_constant_tracks(there, skeleton, out);
  }
  if (map.weight_source.empty() || first_weight.empty()) return out;
  out.weights.clear();
  for (const WeightAnimation& weights : animation.weights) {
    std::vector<std::uint32_t> partner_of;
    for (std::uint32_t w = first_weight[weights.instance]; w < first_weight[weights.instance + 1]; ++w)
      partner_of.push_back(map.weight_source[w] - first_weight[weights.instance]);
    add_mirrored_weights(weights, partner_of, out.weights);
  }
  return out;
}

}  // namespace sinew
