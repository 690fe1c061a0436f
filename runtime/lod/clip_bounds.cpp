// SPDX-License-Identifier: MIT
#include "runtime/lod/clip_bounds.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "runtime/base/contract.h"
#include "runtime/compress/clip_error.h"
#include "runtime/lod/pose_drift.h"
#include "runtime/math/affine.h"
#include "runtime/math/quaternion.h"
#include "runtime/plan/plan_assets.h"

namespace sinew {
namespace {

constexpr std::size_t kPieces = 8;  // per key interval; fewer if there are many intervals
constexpr std::size_t kPosesPerPiece = 5;
constexpr double kRounding = 3e-5;  // rounding of float, relative to the size of the box and its distance

/// Vertices that follow one joint.
struct Part {
  std::uint32_t joint = 0;
  Aabb box;                 // in the joint's space
  double farthest_m = 0.0;  // largest distance of a corner from the joint
};

void grow(Aabb& box, double by_m) {
  const auto most = static_cast<float>(by_m);
  if (!box.empty()) {
    box.lower -= most;
    box.upper += most;
  }
}

double diagonal(const Aabb& box) { return safe_length(Vec3<double>(box.upper) - Vec3<double>(box.lower)); }

/// Largest magnitude of each weight of a track. For cubic tracks it includes the control points, whose hull encloses
/// the curve.
void raise(const WeightTrack& track, std::span<double> largest) {
  const std::size_t targets = track.target_count, keys = track.key_count();
  const bool cubic = track.interpolation == Interpolation::cubic_spline;
  const auto value = [&](std::size_t key, std::size_t part, std::size_t t) {
    return static_cast<double>(track.values[((cubic ? 3 * key + part : key)) * targets + t]);
  };
  for (std::size_t k = 0; k < keys; ++k)
    for (std::size_t t = 0; t < targets; ++t) {
      const double at_key = value(k, 1, t);
      largest[t] = std::max(largest[t], std::abs(at_key));
      if (!cubic) continue;
      const auto third = [&](std::size_t from, std::size_t to) {
        return static_cast<double>(track.times_s[to] - track.times_s[from]) / 3.0;
      };
      if (k > 0) largest[t] = std::max(largest[t], std::abs(at_key - third(k - 1, k) * value(k, 0, t)));
      if (k + 1 < keys) largest[t] = std::max(largest[t], std::abs(at_key + third(k, k + 1) * value(k, 2, t)));
    }
}

/// How far morphing can move a vertex of the instance, in mesh space.
double morph_reach(const Scene& scene, const Animation* animation, std::uint32_t instance) {
  const MeshInstance& shown = scene.instances[instance];
  std::vector<double> largest(shown.rest_weights.size());
  for (std::size_t t = 0; t < largest.size(); ++t) largest[t] = std::abs(static_cast<double>(shown.rest_weights[t]));
  if (animation != nullptr)
    for (const WeightAnimation& animated : animation->weights)
      if (animated.instance == instance) raise(animated.weights, std::span(largest).subspan(animated.first_target));
  double most = 0.0;
  for (const Primitive& primitive : scene.meshes[shown.mesh].primitives) {
    double reach = 0.0;
    for (std::size_t t = 0; t < primitive.morphs.targets.size(); ++t) {
      double longest = 0.0;
      for (const glm::vec3& delta : primitive.morphs.targets[t].positions.deltas)
        longest = std::max(longest, safe_length(Vec3<double>(delta)));
      reach += largest[t] * longest;
    }
    most = std::max(most, reach);
  }
  return most;
}

void add_part(std::vector<Part>& parts, std::uint32_t joint, Aabb box, double grown_m) {
  if (box.empty()) return;
  grow(box, grown_m);
  Part part{joint, box};
  for (const Vec3<double>& corner : corners_of(box)) part.farthest_m = std::max(part.farthest_m, safe_length(corner));
  parts.push_back(part);
}

void add_rigid_parts(const Scene& scene, const MeshInstance& instance, double morphed_m, std::vector<Part>& parts) {
  Aabb mesh;
  for (const Primitive& primitive : scene.meshes[instance.mesh].primitives)
    if (!primitive.bounds.empty()) {
      mesh.add(primitive.bounds.lower);
      mesh.add(primitive.bounds.upper);
    }
  if (instance.copies.empty()) return add_part(parts, instance.joint, mesh, morphed_m);
  if (mesh.empty()) return;
  for (const Transform& copy : instance.copies) {
    const Affined place = affine_from_transform(in_double(copy));
    Aabb box;
    for (const Vec3<double>& corner : corners_of(mesh)) box.add(glm::vec3(transform_point(place, corner)));
    add_part(parts, instance.joint, box, morphed_m * largest_stretch(place));
  }
}

void add_skinned_parts(const Scene& scene, const MeshInstance& instance, double morphed_m, std::vector<Part>& parts) {
  const Skin& skin = scene.skins[instance.skin];
  std::vector<Aabb> boxes(skin.joints.size());
  for (const Primitive& primitive : scene.meshes[instance.mesh].primitives)
    for (const InfluenceGroup& group : primitive.influences.groups)
      for (std::uint32_t v = 0; v < group.vertex_count; ++v)
        for (std::uint32_t i = 0; i < group.influence_count; ++i) {
          const std::uint16_t joint =
              primitive.influences.joints[group.first_influence + v * group.influence_count + i];
          boxes[joint].add(transform_point(skin.inverse_bind[joint], primitive.positions[group.first_vertex + v]));
        }
  for (std::size_t j = 0; j < boxes.size(); ++j)
    add_part(parts, skin.joints[j], boxes[j], morphed_m * largest_stretch(affine_cast<double>(skin.inverse_bind[j])));
}

/// Attaches the parts of left-out joints to their nearest kept ancestors.
void attach_left_out_parts(std::span<const JointMapping> joint_map, std::vector<Part>& parts) {
  std::vector<Part> hung;
  for (const Part& part : parts) {
    const JointMapping& mapped = joint_map[part.joint];
    Aabb there;
    for (const Vec3<double>& corner : corners_of(part.box))
      there.add(glm::vec3(transform_point(mapped.kept_from_joint, corner)));
    add_part(hung, mapped.kept_joint, mapped.is_kept ? part.box : there, 0.0);
  }
  parts = std::move(hung);
}

/// Splits the vertices of an instance by the joints that they follow. Returns no parts if joints alone cannot bound the
/// vertices: correctives morph them, or only some primitives are skinned.
std::vector<Part> parts_of(const Scene& scene, const Animation* animation, std::uint32_t i) {
  const MeshInstance& instance = scene.instances[i];
  const std::vector<Primitive>& primitives = scene.meshes[instance.mesh].primitives;
  const auto skinned = std::count_if(primitives.begin(), primitives.end(), [&](const Primitive& p) {
    return instance.skin != kNone && !p.influences.empty();
  });
  std::vector<Part> parts;
  if (skinned != 0 && static_cast<std::size_t>(skinned) != primitives.size()) return parts;
  if (!scene.correctives.empty() && !instance.rest_weights.empty()) return parts;
  const double morphed_m = morph_reach(scene, animation, i);
  if (skinned != 0)
    add_skinned_parts(scene, instance, morphed_m, parts);
  else
    add_rigid_parts(scene, instance, morphed_m, parts);
  return parts;
}

void add_piece(const PoseDrift& drift, std::span<const Part> parts, Aabb& box) {
  for (const Part& part : parts) {
    Aabb there;
    for (const Vec3<double>& corner : corners_of(part.box))
      there.add(glm::vec3(transform_point(drift.middle()[part.joint], corner)));
    const Drift& stray = drift.drifts()[part.joint];
    grow(there, stray.fixed_m + stray.per_metre * part.farthest_m);
    box.add(there.lower);
    box.add(there.upper);
  }
}

/// Adds the margins that the pieces do not cover: bulging of the skinning, rounding and the error of the clip.
void add_margins(const Clip* clip, Skinning skinning, bool skinned, Aabb& box) {
  if (box.empty()) return;
  const double far = std::max(safe_length(Vec3<double>(box.lower)), safe_length(Vec3<double>(box.upper)));
  double more = kRounding * (far + diagonal(box));
  if (skinned && skinning != Skinning::linear) more += 0.5 * diagonal(box);
  if (clip != nullptr && clip->certificate()) more += clip->certificate()->measured_m;
  grow(box, more);
}

/// Boxes over all times of a clip, computed from its keys.
std::vector<Aabb> boxes_over(const Scene& scene, std::span<const JointMapping> joint_map, std::uint32_t clip) {
  const Animation rest;
  const Animation* animation = clip < scene.animations.size() ? &scene.animations[clip] : nullptr;
  std::vector<Aabb> boxes(scene.instances.size());
  const std::vector<float> keys = key_times(animation != nullptr ? *animation : rest);
  const std::size_t poses = kPosesPerPiece * std::max<std::size_t>(scene.skeleton.joint_count(), 1);
  if (keys.size() > kMaxBoundsPoses / poses) return boxes;
  const std::size_t pieces = std::clamp<std::size_t>(kMaxBoundsPoses / (poses * keys.size()), 1, kPieces);
  std::vector<std::vector<Part>> parts;
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    attach_left_out_parts(joint_map, parts.emplace_back(parts_of(scene, animation, i)));

  PoseDrift drift(scene.skeleton, animation != nullptr ? *animation : rest);
  const auto bound_interval = [&](double begin_s, double end_s) {
    drift.bound_interval(begin_s, end_s);
    for (std::size_t i = 0; i < boxes.size(); ++i) add_piece(drift, parts[i], boxes[i]);
  };
  for (std::size_t k = 0; k + 1 < keys.size(); ++k) {
    const double begin_s = static_cast<double>(keys[k]),
                 end_s = std::nextafter(static_cast<double>(keys[k + 1]),
                                        begin_s);  // ends just before the next key, which may jump
    for (std::size_t p = 0; p < pieces; ++p) {
      const double step_s = (end_s - begin_s) / static_cast<double>(pieces);
      bound_interval(begin_s + static_cast<double>(p) * step_s,
                     p + 1 == pieces ? end_s : begin_s + static_cast<double>(p + 1) * step_s);
    }
  }
  bound_interval(static_cast<double>(keys.back()), static_cast<double>(keys.back()));
  return boxes;
}

}  // namespace

std::vector<Aabb> clip_boxes(const Scene& scene, std::uint32_t clip) {
  return boxes_over(scene, map_joints(scene, {}, nullptr), clip);
}

std::vector<Aabb> clip_bounds(const Scene& scene, const Needs& needs, std::uint32_t clip,
                              std::span<const Aabb> stored) {
  CONTRACT(stored.empty() || stored.size() == scene.instances.size());
  const bool is_known = needs.out.skeleton_lod.kept.empty() && !stored.empty();
  std::vector<Aabb> boxes =
      is_known ? std::vector<Aabb>(stored.begin(), stored.end())
               : boxes_over(scene, map_joints(scene, needs.out.skeleton_lod, needs.in.mirror.get()), clip);
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    add_margins(clip < scene.clips.size() ? &scene.clips[clip] : nullptr, needs.skin.kind_of(i),
                scene.instances[i].skin != kNone, boxes[i]);
  return boxes;
}

}  // namespace sinew
