// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "runtime/model/mesh_checks.h"
#include "runtime/model/scene.h"

namespace sinew {
namespace {

void check_skeleton(const Skeleton& s, Findings& f) noexcept {
  const std::size_t joints = s.joint_count();
  f.require_size(s.rest.size(), joints);
  f.require_size(s.fixed_matrix_of.size(), joints);
  for (const std::size_t size : {s.names.size(), s.node_of_joint.size(), s.joint_of_node.size()})
    f.require_size_or_none(size, joints);
  f.require_finite(s.rest);
  f.require_unit(s.rest);
  f.require_finite(s.fixed_matrices);
  for (const std::uint32_t i : s.fixed_matrix_of) f.require_optional_index(i, s.fixed_matrices.size());
  f.require_indices(s.node_of_joint, joints);
  f.require_indices(s.joint_of_node, joints);
  if (f.code() != ErrorCode::ok) return;
  for (std::uint32_t j = 0; j < s.node_of_joint.size() && j < s.joint_of_node.size(); ++j)
    f.require(s.joint_of_node[s.node_of_joint[j]] == j, ErrorCode::index_out_of_range);
}

/// Requires contiguous levels, and that the parent of each joint is in the level above. This excludes cycles.
void check_levels(const Skeleton& s, Findings& f) noexcept {
  const auto& begin = s.level_begin;
  if (begin.empty() && s.joint_count() == 0) return;
  f.require(!begin.empty() && begin.front() == 0 && begin.back() == s.joint_count(), ErrorCode::size_mismatch);
  for (std::size_t l = 0; l + 1 < begin.size() && f.code() == ErrorCode::ok; ++l) {
    f.require(begin[l] <= begin[l + 1] && begin[l + 1] <= s.joint_count(), ErrorCode::parents_not_first);
    if (f.code() != ErrorCode::ok) return;
    for (std::uint32_t j = begin[l]; j < begin[l + 1]; ++j) {
      const std::uint32_t parent = s.parents[j];
      const bool one_up = l == 0 ? parent == kNone : parent != kNone && parent >= begin[l - 1] && parent < begin[l];
      f.require(one_up, ErrorCode::parents_not_first);
    }
  }
}

std::size_t things_with(const Scene& scene, PropertyKind kind) noexcept {
  if (kind > PropertyKind::texture_scale) return 0;
  if (kind == PropertyKind::node_visible) return scene.skeleton.joint_count();
  if (kind <= PropertyKind::camera_far) return scene.cameras.size();
  return kind <= PropertyKind::light_outer_cone ? scene.lights.size() : scene.materials.size();
}

/// Requires entries that are sorted by target, and whose components are contiguous.
void check_property_table(const Scene& scene, Findings& f) noexcept {
  const PropertyTable& table = scene.properties;
  std::size_t first = 0;
  for (const PropertyTable::Entry& entry : table.entries) {
    f.require_index(entry.target.index, things_with(scene, entry.target.kind));
    f.require(entry.target.slot <= TextureSlot::emissive, ErrorCode::index_out_of_range);
    f.require(entry.first == first && entry.count == component_count(entry.target.kind), ErrorCode::size_mismatch);
    first += entry.count;
  }
  f.require_size(table.rest.size(), first);
  f.require_finite(table.rest);
  const auto not_rising = [](const PropertyTable::Entry& a, const PropertyTable::Entry& b) {
    return !(a.target < b.target);
  };
  f.require(std::adjacent_find(table.entries.begin(), table.entries.end(), not_rising) == table.entries.end(),
            ErrorCode::unsupported);
}

void check_property(const Scene& scene, const PropertyTrack& track, Findings& f) noexcept {
  f.require_index(track.target.index, things_with(scene, track.target.kind));
  f.require_size(track.values.target_count, component_count(track.target.kind));
  f.require(scene.properties.find(track.target) != nullptr, ErrorCode::index_out_of_range);
  f.require(!is_flag(track.target.kind) || track.values.interpolation == Interpolation::step, ErrorCode::unsupported);
  if (!track.values.empty()) f.add(check(track.values));
}

void check_animations(std::span<const Animation> animations, const Scene& scene, Findings& f) noexcept {
  for (const Animation& animation : animations) {
    f.require(std::isfinite(animation.duration_s) && animation.duration_s >= 0.0, ErrorCode::not_finite);
    f.add(check(animation.annotations, animation.duration_s));
    for (const BoneAnimation& bone : animation.bones) {
      f.require_index(bone.joint, scene.skeleton.joint_count());
      if (!bone.translation.empty()) f.add(check(bone.translation));
      if (!bone.rotation.empty()) f.add(check(bone.rotation));
      if (!bone.scale.empty()) f.add(check(bone.scale));
    }
    for (const WeightAnimation& a : animation.weights) {
      f.require_index(a.instance, scene.instances.size());
      if (f.code() != ErrorCode::ok) return;
      f.require(std::size_t{a.first_target} + a.weights.target_count <= scene.instances[a.instance].rest_weights.size(),
                ErrorCode::size_mismatch);
      if (!a.weights.empty()) f.add(check(a.weights));
    }
    for (const PropertyTrack& track : animation.properties) check_property(scene, track, f);
  }
}

void check_clips(const Scene& scene, Findings& f) noexcept {
  f.require_size(scene.clips.size(), scene.animations.size());
  for (const Clip& clip : scene.clips) {
    f.require_size(clip.joint_count(), scene.skeleton.joint_count());
    f.require_size(clip.weight_count(), scene.weight_count());
    f.require_size(clip.property_count(), scene.properties.rest.size());
  }
  f.require_size(scene.first_weight.size(), scene.instances.size() + 1);
  if (f.code() != ErrorCode::ok) return;
  std::size_t first = 0;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    f.require_size(scene.first_weight[i], first);
    first += scene.instances[i].rest_weights.size();
  }
  f.require_size(scene.first_weight.back(), first);
}

void check_skins(const Scene& scene, Findings& f) noexcept {
  for (const Skin& skin : scene.skins) {
    f.require_size(skin.inverse_bind.size(), skin.joints.size());
    f.require_finite(skin.inverse_bind);
    for (const std::uint32_t j : skin.joints) f.require_index(j, scene.skeleton.joint_count());
    f.require_optional_index(skin.skeleton_root, scene.skeleton.joint_count());
  }
}

void check_correctives(const Scene& scene, Findings& f) noexcept {
  for (const PoseCorrective& corrective : scene.correctives)
    f.add(check(corrective, scene.skeleton.joint_count(), scene.weight_count()));
}

bool are_finite(std::initializer_list<float> numbers) noexcept {
  return all_finite(std::span<const float>(numbers.begin(), numbers.size()));
}

void check_texture_use(const TextureUse& use, const Scene& scene, Findings& f) noexcept {
  f.require_optional_index(use.texture, scene.textures.size());
  f.require(are_finite({use.offset.x, use.offset.y, use.rotation_rad, use.scale.x, use.scale.y}),
            ErrorCode::not_finite);
}

void check_material(const Material& m, const Scene& scene, Findings& f) noexcept {
  for (const TextureUse* use : texture_uses(m)) check_texture_use(*use, scene, f);
  f.require(are_finite({m.base_color.x, m.base_color.y, m.base_color.z, m.base_color.w, m.metallic, m.roughness,
                        m.normal_scale, m.occlusion_strength, m.emissive.x, m.emissive.y, m.emissive.z,
                        m.emissive_strength, m.alpha_cutoff}),
            ErrorCode::not_finite);
  const Specular& s = m.specular;
  const Clearcoat& c = m.clearcoat;
  const Iridescence& i = m.iridescence;
  const Volume& v = m.volume;
  f.require(are_finite({i.factor, i.ior, i.thinnest_nm, i.thickest_nm, m.anisotropy.strength, m.anisotropy.rotation_rad,
                        v.thickness_m, v.attenuation_distance_m, v.attenuation_color.x, v.attenuation_color.y,
                        v.attenuation_color.z}),
            ErrorCode::not_finite);
  f.require(are_finite({s.ior, s.factor, s.color.x, s.color.y, s.color.z, c.factor, c.roughness, c.normal_scale,
                        m.sheen.color.x, m.sheen.color.y, m.sheen.color.z, m.sheen.roughness, m.transmission.factor}),
            ErrorCode::not_finite);
}

void check_cameras_and_lights(const Scene& scene, Findings& f) noexcept {
  for (const Camera& c : scene.cameras) {
    f.require_optional_index(c.joint, scene.skeleton.joint_count());
    f.require(are_finite({c.fov_y_rad, c.aspect, c.half_width, c.half_height, c.near_m, c.far_m}),
              ErrorCode::not_finite);
  }
  for (const Light& l : scene.lights) {
    f.require_optional_index(l.joint, scene.skeleton.joint_count());
    f.require(are_finite({l.color.x, l.color.y, l.color.z, l.intensity, l.range_m, l.inner_cone_rad, l.outer_cone_rad}),
              ErrorCode::not_finite);
  }
}

void check_appearance(const Scene& scene, Findings& f) noexcept {
  for (const Material& m : scene.materials) check_material(m, scene, f);
  for (const Texture& t : scene.textures) f.require_optional_index(t.image, scene.images.size());
  for (const Image& i : scene.images)
    if (!i.rgba.empty())
      f.require_size(i.rgba.size(), std::size_t{4} * i.width * i.height);  // empty pixels: only the header was read
  check_cameras_and_lights(scene, f);
  for (const SceneRoots& roots : scene.scenes) f.require_indices(roots.joints, scene.skeleton.joint_count());
  f.require_optional_index(scene.default_scene, scene.scenes.size());
}

}  // namespace

ErrorCode check_animations(std::span<const Animation> animations, const Scene& scene) noexcept {
  Findings f;
  check_animations(animations, scene, f);
  return f.code();
}

ErrorCode check(const Scene& scene) {
  Findings f;
  check_skeleton(scene.skeleton, f);
  if (f.code() == ErrorCode::ok) check_levels(scene.skeleton, f);
  f.require_indices(scene.hidden_joints, scene.skeleton.joint_count());
  check_property_table(scene, f);
  check_skins(scene, f);
  check_meshes(scene, f);
  check_animations(scene.animations, scene, f);
  check_clips(scene, f);
  check_correctives(scene, f);
  check_appearance(scene, f);
  return f.code();
}

}  // namespace sinew
