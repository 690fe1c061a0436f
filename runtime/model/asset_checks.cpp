// SPDX-License-Identifier: MIT
#include <cmath>

#include "runtime/base/all_finite.h"
#include "runtime/base/index.h"
#include "runtime/model/scene.h"

namespace sinew {
namespace {

/// Keeps the first broken rule.
class Findings {
 public:
  void require(bool holds, ErrorCode otherwise) noexcept {
    if (!holds && code_ == ErrorCode::ok) code_ = otherwise;
  }
  void require_index(std::uint32_t index, std::size_t count) noexcept {
    require(index < count, ErrorCode::index_out_of_range);
  }
  void require_optional_index(std::uint32_t index, std::size_t count) noexcept {
    require(index == kNone || index < count, ErrorCode::index_out_of_range);
  }
  void require_size(std::size_t found, std::size_t expected) noexcept {
    require(found == expected, ErrorCode::size_mismatch);
  }
  void require_size_or_none(std::size_t found, std::size_t expected) noexcept {
    require(found == 0 || found == expected, ErrorCode::size_mismatch);
  }
  void add(ErrorCode code) noexcept { require(code == ErrorCode::ok, code); }
  template <class Element>
  void require_finite(const std::vector<Element>& elements) noexcept {
    require(all_finite(std::span<const Element>(elements)), ErrorCode::not_finite);
  }
  template <class Index>
  void require_indices(const std::vector<Index>& indices, std::size_t count) noexcept {
    require(all_below(indices, count), ErrorCode::index_out_of_range);
  }
  ErrorCode code() const noexcept { return code_; }

 private:
  ErrorCode code_ = ErrorCode::ok;
};

void check_skeleton(const Skeleton& s, Findings& f) noexcept {
  const std::size_t joints = s.joint_count();
  f.require_size(s.rest.size(), joints);
  f.require_size(s.fixed_matrix_of.size(), joints);
  for (const std::size_t size : {s.names.size(), s.node_of_joint.size(), s.joint_of_node.size()})
    f.require_size_or_none(size, joints);
  f.require_finite(s.rest);
  f.require_finite(s.fixed_matrices);
  for (std::size_t j = 0; j < joints; ++j)
    f.require(s.parents[j] == kNone || s.parents[j] < j, ErrorCode::parents_not_first);
  for (const std::uint32_t i : s.fixed_matrix_of) f.require_optional_index(i, s.fixed_matrices.size());
  for (const std::uint32_t i : s.node_of_joint) f.require_index(i, joints);
  for (const std::uint32_t i : s.joint_of_node) f.require_index(i, joints);
}

void check_hidden(const Scene& scene, Findings& f) noexcept {
  for (const std::uint32_t j : scene.hidden_joints) f.require_index(j, scene.skeleton.joint_count());
}

/// Levels are contiguous, and each joint's parent lies one level up.
void check_levels(const Skeleton& s, Findings& f) noexcept {
  const auto& begin = s.level_begin;
  if (begin.empty() && s.joint_count() == 0) return;
  f.require(!begin.empty() && begin.front() == 0 && begin.back() == s.joint_count(), ErrorCode::size_mismatch);
  for (std::size_t l = 0; l + 1 < begin.size() && f.code() == ErrorCode::ok; ++l) {
    f.require(begin[l] <= begin[l + 1], ErrorCode::parents_not_first);
    if (f.code() != ErrorCode::ok) return;
    for (std::uint32_t j = begin[l]; j < begin[l + 1]; ++j) {
      const std::uint32_t parent = s.parents[j];
      const bool one_up = l == 0 ? parent == kNone : parent != kNone && parent >= begin[l - 1] && parent < begin[l];
      f.require(one_up, ErrorCode::parents_not_first);
    }
  }
}

std::size_t things_with(const Scene& scene, PropertyKind kind) noexcept {
  if (kind == PropertyKind::node_visible) return scene.skeleton.joint_count();
  if (kind <= PropertyKind::camera_far) return scene.cameras.size();
  return kind <= PropertyKind::light_outer_cone ? scene.lights.size() : scene.materials.size();
}

void check_property(const Scene& scene, const PropertyTrack& track, Findings& f) noexcept {
  f.require_index(track.target.index, things_with(scene, track.target.kind));
  f.require_size(track.values.target_count, component_count(track.target.kind));
  f.require(scene.properties.find(track.target) != nullptr, ErrorCode::index_out_of_range);
  f.require(!is_flag(track.target.kind) || track.values.interpolation == Interpolation::step, ErrorCode::unsupported);
  if (!track.values.empty()) f.add(check(track.values));
}

void check_animations(const Scene& scene, Findings& f) noexcept {
  for (const Animation& animation : scene.animations) {
    f.require(std::isfinite(animation.duration_s) && animation.duration_s >= 0.0, ErrorCode::not_finite);
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
  for (std::size_t i = 0; i + 1 < scene.first_weight.size() && i < scene.instances.size(); ++i)
    f.require_size(scene.first_weight[i + 1] - scene.first_weight[i], scene.instances[i].rest_weights.size());
}

void check_skins(const Scene& scene, Findings& f) noexcept {
  for (const Skin& skin : scene.skins) {
    f.require_size(skin.inverse_bind.size(), skin.joints.size());
    f.require_finite(skin.inverse_bind);
    for (const std::uint32_t j : skin.joints) f.require_index(j, scene.skeleton.joint_count());
    f.require_optional_index(skin.skeleton_root, scene.skeleton.joint_count());
  }
}

/// Groups cover the vertices in order, and each has its joints and weights.
void check_influences(const VertexInfluences& influences, std::size_t vertex_count, Findings& f) noexcept {
  if (influences.empty()) return;
  f.require_size(influences.weights.size(), influences.joints.size());
  f.require_finite(influences.weights);
  std::size_t covered = 0;
  for (const InfluenceGroup& group : influences.groups) {
    f.require(group.first_vertex == covered && group.influence_count >= 1, ErrorCode::size_mismatch);
    covered += group.vertex_count;
    const std::size_t used = static_cast<std::size_t>(group.vertex_count) * group.influence_count;
    f.require(group.first_influence + used <= influences.joints.size(), ErrorCode::index_out_of_range);
  }
  f.require_size(covered, vertex_count);
  bool negative = false;
  for (const float w : influences.weights) negative |= w < 0.0f;
  f.require(!negative, ErrorCode::unsupported);
}

template <class V>
void check_deltas(const SparseDeltas<V>& sparse, std::size_t vertex_count, Findings& f) noexcept {
  f.require_size(sparse.deltas.size(), sparse.vertices.size());
  f.require_finite(sparse.deltas);
  f.require_indices(sparse.vertices, vertex_count);
  bool rising = true;
  for (std::size_t i = 1; i < sparse.vertices.size(); ++i) rising &= sparse.vertices[i - 1] < sparse.vertices[i];
  f.require(rising, ErrorCode::unsupported);
}

void check_morphs(const MorphSet& morphs, std::size_t target_count, std::size_t vertex_count, Findings& f) noexcept {
  f.require_size_or_none(morphs.targets.size(), target_count);
  for (const MorphTarget& target : morphs.targets) {
    check_deltas(target.positions, vertex_count, f);
    check_deltas(target.normals, vertex_count, f);
    check_deltas(target.tangents, vertex_count, f);
    check_deltas(target.colors, vertex_count, f);
    for (const auto& set : target.texcoords) check_deltas(set, vertex_count, f);
  }
}

void check_primitive(const Primitive& p, std::size_t target_count, std::size_t material_count, Findings& f) noexcept {
  const std::size_t vertices = p.vertex_count();
  for (const std::size_t size :
       {p.normals.size(), p.tangents.size(), p.colors.size(), p.centers_of_rotation.size(), p.source_vertex.size()})
    f.require_size_or_none(size, vertices);
  f.require_finite(p.positions);
  f.require_finite(p.normals);
  f.require_finite(p.tangents);
  f.require_finite(p.colors);
  f.require_finite(p.centers_of_rotation);
  for (const auto& set : p.texcoords) {
    f.require_size_or_none(set.size(), vertices);
    f.require_finite(set);
  }
  f.require_indices(p.indices, vertices);
  const std::size_t per_element = static_cast<std::size_t>(p.topology) + 1;
  f.require(p.indices.size() % per_element == 0, ErrorCode::size_mismatch);
  f.require_optional_index(p.material, material_count);
  check_influences(p.influences, vertices, f);
  check_morphs(p.morphs, target_count, vertices, f);
}

void check_variants(const Primitive& p, const Scene& scene, Findings& f) noexcept {
  for (const VariantMaterial& other : p.variant_materials) {
    f.require_index(other.variant, scene.variants.size());
    f.require_index(other.material, scene.materials.size());
  }
}

void check_meshes(const Scene& scene, Findings& f) noexcept {
  for (const Mesh& mesh : scene.meshes) {
    f.require_finite(mesh.default_weights);
    f.require_size_or_none(mesh.target_names.size(), mesh.target_count());
    for (const Primitive& p : mesh.primitives) {
      check_primitive(p, mesh.target_count(), scene.materials.size(), f);
      check_variants(p, scene, f);
    }
  }
}

/// Every joint index of the mesh exists in this skin: one mesh may hang on several skins (G36).
void check_binding(const Mesh& mesh, const Skin& skin, Findings& f) noexcept {
  for (const Primitive& p : mesh.primitives) f.require_indices(p.influences.joints, skin.joints.size());
}

void check_instances(const Scene& scene, Findings& f) noexcept {
  for (const MeshInstance& instance : scene.instances) {
    f.require_index(instance.joint, scene.skeleton.joint_count());
    f.require_index(instance.mesh, scene.meshes.size());
    f.require_optional_index(instance.skin, scene.skins.size());
    if (f.code() != ErrorCode::ok) return;
    const Mesh& mesh = scene.meshes[instance.mesh];
    f.require_size(instance.rest_weights.size(), mesh.target_count());
    f.require_finite(instance.rest_weights);
    f.require_finite(instance.copies);
    f.require(instance.copies.empty() || instance.skin == kNone, ErrorCode::unsupported);
    if (instance.skin != kNone) check_binding(mesh, scene.skins[instance.skin], f);
  }
}

void check_correctives(const Scene& scene, Findings& f) noexcept {
  for (const PoseCorrective& corrective : scene.correctives)
    f.add(check(corrective, scene.skeleton.joint_count(), scene.weight_count()));
}

void check_texture_use(const TextureUse& use, const Scene& scene, Findings& f) noexcept {
  f.require_optional_index(use.texture, scene.textures.size());
}

void check_appearance(const Scene& scene, Findings& f) noexcept {
  for (const Material& m : scene.materials)
    for (const TextureUse* use : {&m.base_color_texture, &m.metallic_roughness_texture, &m.normal_texture,
                                  &m.occlusion_texture, &m.emissive_texture})
      check_texture_use(*use, scene, f);
  for (const Texture& t : scene.textures) f.require_optional_index(t.image, scene.images.size());
  for (const Image& i : scene.images)
    if (!i.rgba.empty())
      f.require_size(i.rgba.size(), std::size_t{4} * i.width * i.height);  // else only its header has been read
  for (const Camera& c : scene.cameras) f.require_optional_index(c.joint, scene.skeleton.joint_count());
  for (const Light& l : scene.lights) f.require_optional_index(l.joint, scene.skeleton.joint_count());
  for (const SceneRoots& roots : scene.scenes)
    for (const std::uint32_t j : roots.joints) f.require_index(j, scene.skeleton.joint_count());
  f.require_optional_index(scene.default_scene, scene.scenes.size());
}

}  // namespace

ErrorCode check(const Scene& scene) noexcept {
  Findings f;
  check_skeleton(scene.skeleton, f);
  if (f.code() == ErrorCode::ok) check_levels(scene.skeleton, f);
  check_hidden(scene, f);
  check_skins(scene, f);
  check_meshes(scene, f);
  check_instances(scene, f);
  check_animations(scene, f);
  check_clips(scene, f);
  check_correctives(scene, f);
  check_appearance(scene, f);
  return f.code();
}

}  // namespace sinew
