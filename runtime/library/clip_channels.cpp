// SPDX-License-Identifier: MIT
#include "runtime/library/clip_channels.h"

#include <string_view>
#include <utility>
#include <vector>

#include "runtime/animation/skeleton_signature.h"

namespace sinew {
namespace {

/// The mesh's name. If it has none, the name of the joint, since many exporters name only nodes.
std::string_view name_of(const MeshInstance& instance, const Scene& scene) noexcept {
  const std::string_view mesh = scene.meshes[instance.mesh].name;
  const std::vector<std::string>& joints = scene.skeleton.names;
  return mesh.empty() && instance.joint < joints.size() ? std::string_view(joints[instance.joint]) : mesh;
}

std::vector<std::string> weight_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const MeshInstance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    const std::string of_mesh(name_of(instance, scene));
    for (std::size_t t = 0; t < instance.rest_weights.size(); ++t) {
      const bool is_named = t < mesh.target_names.size() && !mesh.target_names[t].empty();
      names.push_back(of_mesh.empty() ? "" : of_mesh + '/' + (is_named ? mesh.target_names[t] : std::to_string(t)));
    }
  }
  return names;
}

std::string_view name_of(PropertyKind kind) noexcept {
  switch (kind) {
    case PropertyKind::node_visible: return "visible";
    case PropertyKind::camera_fov_y: return "fov_y";
    case PropertyKind::camera_aspect: return "aspect";
    case PropertyKind::camera_half_width: return "half_width";
    case PropertyKind::camera_half_height: return "half_height";
    case PropertyKind::camera_near: return "near";
    case PropertyKind::camera_far: return "far";
    case PropertyKind::light_color: return "color";
    case PropertyKind::light_intensity: return "intensity";
    case PropertyKind::light_range: return "range";
    case PropertyKind::light_inner_cone: return "inner_cone";
    case PropertyKind::light_outer_cone: return "outer_cone";
    case PropertyKind::base_color: return "base_color";
    case PropertyKind::metallic: return "metallic";
    case PropertyKind::roughness: return "roughness";
    case PropertyKind::normal_scale: return "normal_scale";
    case PropertyKind::occlusion_strength: return "occlusion_strength";
    case PropertyKind::emissive: return "emissive";
    case PropertyKind::emissive_strength: return "emissive_strength";
    case PropertyKind::alpha_cutoff: return "alpha_cutoff";
    case PropertyKind::texture_offset: return "offset";
    case PropertyKind::texture_rotation: return "rotation";
    case PropertyKind::texture_scale: break;
  }
  return "scale";
}

std::string_view name_of(TextureSlot slot) noexcept {
  switch (slot) {
    case TextureSlot::base_color: return "base_color_texture/";
    case TextureSlot::metallic_roughness: return "metallic_roughness_texture/";
    case TextureSlot::normal: return "normal_texture/";
    case TextureSlot::occlusion: return "occlusion_texture/";
    case TextureSlot::emissive: break;
  }
  return "emissive_texture/";
}

/// The kind and name of the target's joint, camera, light or material; empty if it has no name.
std::string thing_of(const Scene& scene, const PropertyTarget& target) {
  const auto named = [](std::string_view kind, std::string_view name) {
    return name.empty() ? std::string{} : std::string(kind).append(name).append("/");
  };
  if (target.kind == PropertyKind::node_visible) {
    const std::vector<std::string>& names = scene.skeleton.names;
    return named("joint ", target.index < names.size() ? std::string_view(names[target.index]) : std::string_view{});
  }
  if (target.kind <= PropertyKind::camera_far) return named("camera ", scene.cameras[target.index].name.str());
  if (target.kind <= PropertyKind::light_outer_cone) return named("light ", scene.lights[target.index].name.str());
  return named("material ", scene.materials[target.index].name);
}

}  // namespace

std::string property_name(const Scene& scene, const PropertyTarget& target) {
  std::string name = thing_of(scene, target);
  if (name.empty()) return name;
  if (target.kind >= PropertyKind::texture_offset) name.append(name_of(target.slot));
  return name.append(name_of(target.kind));
}

namespace {

std::vector<std::string> number_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const PropertyTable::Entry& entry : scene.properties.entries) {
    const std::string name = property_name(scene, entry.target);
    for (std::uint32_t c = 0; c < entry.count; ++c)
      names.push_back(name.empty() || entry.count == 1 ? name : name + '/' + std::to_string(c));
  }
  return names;
}

}  // namespace

ClipChannels clip_channels(const Skeleton& skeleton) {
  std::vector<std::string> names = skeleton.names;
  names.resize(skeleton.joint_count());
  return {skeleton_signature(skeleton), std::move(names), {}, {}, clip_rest(skeleton, {}, {})};
}

ClipChannels clip_channels(const Scene& scene) {
  ClipChannels channels = clip_channels(scene.skeleton);
  channels.weights = weight_names(scene);
  channels.numbers = number_names(scene);
  channels.rest = clip_rest(scene.skeleton, rest_weights_of(scene), scene.properties);
  if (!scene.clips.empty()) share_rest(scene.clips.front(), channels.rest);
  return channels;
}

}  // namespace sinew
