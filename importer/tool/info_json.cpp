// SPDX-License-Identifier: MIT
#include "importer/tool/info_json.h"

#include <algorithm>
#include <map>

namespace sinew::tool {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kInterpolationNames[] = {"step", "linear", "cubic_spline", "squad"};
constexpr const char* kTopologyNames[] = {"points", "lines", "triangles"};
constexpr const char* kAlphaNames[] = {"opaque", "mask", "blend"};
constexpr const char* kLightNames[] = {"directional", "point", "spot"};

template <class Enum, std::size_t N>
const char* name_of(Enum value, const char* const (&names)[N]) {
  return names[static_cast<std::size_t>(value)];
}

Json index_or_null(std::uint32_t index) { return index == kNone ? Json(nullptr) : Json(index); }

std::uint32_t node_of(const Scene& scene, std::uint32_t joint) {
  return joint == kNone ? kNone : scene.skeleton.node_of_joint[joint];
}

Json nodes_json(const Skeleton& skeleton) {
  const auto roots = std::count(skeleton.parents.begin(), skeleton.parents.end(), kNone);
  const std::size_t depth = skeleton.level_begin.empty() ? 0 : skeleton.level_begin.size() - 1;
  return {{"count", skeleton.joint_count()},
          {"roots", roots},
          {"depth", depth},
          {"given_as_matrix", skeleton.fixed_matrices.size()}};
}

std::size_t non_zero_deltas(const MorphTarget& target) {
  std::size_t count = target.positions.vertices.size() + target.normals.vertices.size() +
                      target.tangents.vertices.size() + target.colors.vertices.size();
  for (const auto& set : target.texcoords) count += set.vertices.size();
  return count;
}

std::size_t file_vertex_count(const Primitive& primitive) {
  if (primitive.source_vertex.empty()) return primitive.vertex_count();
  std::vector<std::uint32_t> source = primitive.source_vertex;
  std::sort(source.begin(), source.end());
  return static_cast<std::size_t>(std::unique(source.begin(), source.end()) - source.begin());
}

Json primitive_json(const Primitive& primitive, std::map<std::uint32_t, std::uint64_t>& histogram) {
  constexpr std::size_t kCorners[] = {1, 2, 3};
  for (const InfluenceGroup& group : primitive.influences.groups)
    histogram[group.influence_count] += group.vertex_count;
  Json out = {{"topology", name_of(primitive.topology, kTopologyNames)},
              {"vertices", file_vertex_count(primitive)},
              {"vertices_after_splitting", primitive.vertex_count()},
              {"elements", primitive.indices.size() / kCorners[static_cast<std::size_t>(primitive.topology)]},
              {"normals", primitive.flat_normals      ? "made, flat"
                          : primitive.normals.empty() ? "none"
                                                      : "yes"},
              {"tangents", !primitive.tangents.empty()},
              {"texcoord_sets", primitive.texcoords.size()},
              {"colors", !primitive.colors.empty()},
              {"material", index_or_null(primitive.material)}};
  return out;
}

Json mesh_json(const Mesh& mesh) {
  std::map<std::uint32_t, std::uint64_t> histogram;
  std::size_t vertices = 0, triangles = 0;
  Json primitives = Json::array();
  std::vector<std::size_t> deltas(mesh.target_count(), 0);
  for (const Primitive& primitive : mesh.primitives) {
    primitives.push_back(primitive_json(primitive, histogram));
    vertices += file_vertex_count(primitive);
    if (primitive.topology == Topology::triangles) triangles += primitive.indices.size() / 3;
    for (std::size_t t = 0; t < deltas.size() && t < primitive.morphs.targets.size(); ++t)
      deltas[t] += non_zero_deltas(primitive.morphs.targets[t]);
  }
  Json influences = Json::object();
  for (const auto& [count, of_vertices] : histogram) influences[std::to_string(count)] = of_vertices;
  Json out = {{"name", mesh.name},
              {"vertices", vertices},
              {"triangles", triangles},
              {"influences", influences},
              {"primitives", primitives}};
  if (mesh.target_count() == 0) return out;
  Json targets = Json::array();
  for (std::size_t t = 0; t < mesh.target_count(); ++t)
    targets.push_back({{"name", t < mesh.target_names.size() ? mesh.target_names[t] : ""},
                       {"non_zero_deltas", deltas[t]},
                       {"default_weight", mesh.default_weights[t]}});
  out["morph_targets"] = targets;
  return out;
}

/// Channels of an animation by property, their keys and interpolation modes.
struct ChannelTally {
  std::map<std::string, std::uint64_t> by_property, by_mode;
  std::uint64_t channels = 0, keys = 0;

  template <class AnyTrack>
  void add(const char* property, const AnyTrack& track) {
    if (track.empty()) return;
    ++channels;
    keys += track.key_count();
    ++by_property[property];
    ++by_mode[name_of(track.interpolation, kInterpolationNames)];
  }
};

Json clip_json(const Animation& animation, const Clip& clip) {
  ChannelTally tally;
  for (const BoneAnimation& bone : animation.bones) {
    tally.add("translation", bone.translation);
    tally.add("rotation", bone.rotation);
    tally.add("scale", bone.scale);
  }
  for (const WeightAnimation& morph : animation.weights) tally.add("weights", morph.weights);
  return {{"name", animation.name},
          {"duration_s", animation.duration_s},
          {"channels", tally.channels},
          {"channels_by_property", tally.by_property},
          {"modes", tally.by_mode},
          {"keys", tally.keys},
          {"folded_tracks", clip.counts().folded},
          {"key_searches", clip.counts().time_groups},
          {"bytes", clip.byte_size()}};
}

Json instance_json(const Scene& scene, const MeshInstance& instance) {
  return {{"node", node_of(scene, instance.joint)},
          {"node_name", scene.skeleton.names[instance.joint]},
          {"mesh", instance.mesh},
          {"skin", index_or_null(instance.skin)},
          {"rest_weights", instance.rest_weights}};
}

Json material_json(const Material& material) {
  return {{"name", material.name},
          {"alpha", name_of(material.alpha_mode, kAlphaNames)},
          {"double_sided", material.double_sided},
          {"unlit", material.unlit},
          {"base_color", {material.base_color.r, material.base_color.g, material.base_color.b, material.base_color.a}},
          {"metallic", material.metallic},
          {"roughness", material.roughness},
          {"textures",
           {{"base_color", material.base_color_texture.used()},
            {"metallic_roughness", material.metallic_roughness_texture.used()},
            {"normal", material.normal_texture.used()},
            {"occlusion", material.occlusion_texture.used()},
            {"emissive", material.emissive_texture.used()}}}};
}

Json image_json(const Image& image) {
  return {{"name", image.name},
          {"width", image.width},
          {"height", image.height},
          {"missing", image.missing_reason.empty() ? Json(nullptr) : Json(image.missing_reason)}};
}

Json camera_json(const Scene& scene, const Camera& camera) {
  return {{"name", camera.name},
          {"node", index_or_null(node_of(scene, camera.joint))},
          {"kind", camera.perspective ? "perspective" : "orthographic"}};
}

Json light_json(const Scene& scene, const Light& light) {
  return {{"name", light.name},
          {"node", index_or_null(node_of(scene, light.joint))},
          {"kind", name_of(light.kind, kLightNames)},
          {"intensity", light.intensity}};
}

/// One entry per element of `list`, made by `entry`.
template <class T, class Entry>
Json array_of(const std::vector<T>& list, const Entry& entry) {
  Json out = Json::array();
  for (const T& element : list) out.push_back(entry(element));
  return out;
}

}  // namespace

nlohmann::ordered_json info_json(const std::string& name, const ImportedFile& file) {
  const Scene& scene = file.scene;
  Json out = {{"file", name},
              {"bytes", file.facts.file_bytes},
              {"version", file.facts.version},
              {"generator", file.facts.generator},
              {"copyright", file.facts.copyright},
              {"extensions_used", file.facts.extensions_used},
              {"extensions_required", file.facts.extensions_required},
              {"nodes", nodes_json(scene.skeleton)},
              {"scenes", scene.scenes.size()},
              {"default_scene", index_or_null(scene.default_scene)}};
  out["meshes"] = array_of(scene.meshes, mesh_json);
  out["mesh_instances"] = array_of(scene.instances, [&](const MeshInstance& i) { return instance_json(scene, i); });
  out["skins"] = array_of(scene.skins, [](const Skin& skin) {
    return Json{{"name", skin.name}, {"joints", skin.joints.size()}};
  });
  out["clips"] = Json::array();
  for (std::size_t i = 0; i < scene.animations.size(); ++i)
    out["clips"].push_back(clip_json(scene.animations[i], scene.clips[i]));
  out["materials"] = array_of(scene.materials, material_json);
  out["images"] = array_of(scene.images, image_json);
  out["cameras"] = array_of(scene.cameras, [&](const Camera& c) { return camera_json(scene, c); });
  out["lights"] = array_of(scene.lights, [&](const Light& l) { return light_json(scene, l); });
  out["warnings"] = array_of(file.warnings, [](const ImportIssue& issue) {
    return Json{{"rule", issue.rule}, {"pointer", issue.json_pointer}, {"message", issue.detail}};
  });
  return out;
}

}  // namespace sinew::tool
