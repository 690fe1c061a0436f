// SPDX-License-Identifier: MIT
#include "importer/tool/info/info_json.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "importer/read/property_pointer.h"
#include "importer/rewrite_gltf.h"
#include "importer/tool/info/clip_annotations.h"
#include "importer/tool/info/memory_kinds.h"
#include "importer/tool/info/node_tree.h"
#include "importer/tool/info/skin_statistics.h"
#include "importer/tool/model_size.h"
#include "importer/tool/vrm/vrm_info.h"

namespace sinew::tool {
namespace {

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

Json primitive_json(const Primitive& primitive) {
  constexpr std::size_t kCorners[] = {1, 2, 3};
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

Json box_json(const std::optional<RestBox>& box) {
  if (!box) return nullptr;
  return {{"lower", box->lower}, {"upper", box->upper}};
}

/// The box of a mesh in its own space.
Json mesh_box_json(const Mesh& mesh) {
  Aabb box;
  for (const Primitive& primitive : mesh.primitives)
    if (!primitive.bounds.empty()) {
      box.add(primitive.bounds.lower);
      box.add(primitive.bounds.upper);
    }
  if (box.empty()) return nullptr;
  return {{"lower", {box.lower.x, box.lower.y, box.lower.z}}, {"upper", {box.upper.x, box.upper.y, box.upper.z}}};
}

Json mesh_json(const Mesh& mesh) {
  std::size_t vertices = 0, triangles = 0;
  Json primitives = Json::array();
  std::vector<std::size_t> deltas(mesh.target_count(), 0);
  for (const Primitive& primitive : mesh.primitives) {
    primitives.push_back(primitive_json(primitive));
    vertices += file_vertex_count(primitive);
    if (primitive.topology == Topology::triangles) triangles += primitive.indices.size() / 3;
    for (std::size_t t = 0; t < deltas.size() && t < primitive.morphs.targets.size(); ++t)
      deltas[t] += non_zero_deltas(primitive.morphs.targets[t]);
  }
  Json out = {{"name", mesh.name},
              {"vertices", vertices},
              {"triangles", triangles},
              {"bounds", mesh_box_json(mesh)},
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

/// Counts the channels of an animation by property, with their keys and interpolation modes.
struct ChannelTally {
  std::map<std::string, std::uint64_t> by_property, by_mode;
  std::uint64_t channels = 0, keys = 0, most_keys = 0, bytes = 0;

  template <class AnyTrack>
  void add(const std::string& property, const AnyTrack& track) {
    if (track.empty()) return;
    ++channels;
    keys += track.key_count();
    most_keys = std::max<std::uint64_t>(most_keys, track.key_count());
    bytes += track.times_s.size() * sizeof(float) + track.values.size() * sizeof(track.values[0]);
    ++by_property[property];
    ++by_mode[name_of(track.interpolation, kInterpolationNames)];
  }
};

Json clip_json(const Scene& scene, const Animation& animation, const Clip& clip) {
  ChannelTally tally;
  for (const BoneAnimation& bone : animation.bones) {
    tally.add("translation", bone.translation);
    tally.add("rotation", bone.rotation);
    tally.add("scale", bone.scale);
  }
  for (const WeightAnimation& morph : animation.weights) tally.add("weights", morph.weights);
  for (const PropertyTrack& track : animation.properties) {
    const std::string pointer = property_pointer(track.target, scene);
    tally.add(pointer.substr(pointer.rfind('/') + 1), track.values);
  }
  Json out{{"name", animation.name},
           {"duration_s", animation.duration_s},
           {"animated_nodes", animated_nodes(scene, animation)},
           {"channels", tally.channels},
           {"channels_by_property", tally.by_property},
           {"modes", tally.by_mode},
           {"keys", tally.keys},
           {"most_keys_of_a_channel", tally.most_keys},
           {"constant_tracks", clip.counts().folded},
           {"key_searches", clip.counts().time_groups},
           {"bytes_of_keys", tally.bytes},
           {"bytes_compiled", clip.byte_size()}};
  add_annotations(animation.annotations, out);
  return out;
}

Json instance_json(const Scene& scene, const MeshInstance& instance) {
  return {{"node", node_of(scene, instance.joint)},
          {"node_name", scene.skeleton.names[instance.joint]},
          {"mesh", instance.mesh},
          {"skin", index_or_null(instance.skin)},
          {"rest_weights", instance.rest_weights},
          {"copies", std::max<std::size_t>(instance.copies.size(), 1)}};
}

/// The image of each texture that a material uses; null for a texture without one.
Json texture_images(const Scene& scene, const Material& material) {
  Json out = Json::object();
  const auto add = [&](const char* name, const TextureUse& use) {
    if (use.used()) out[name] = index_or_null(scene.textures[use.texture].image);
  };
  add("base_color", material.base_color_texture);
  add("metallic_roughness", material.metallic_roughness_texture);
  add("normal", material.normal_texture);
  add("occlusion", material.occlusion_texture);
  add("emissive", material.emissive_texture);
  return out;
}

Json material_json(const Scene& scene, const Material& material) {
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
            {"emissive", material.emissive_texture.used()}}},
          {"texture_images", texture_images(scene, material)}};
}

Json skin_json(const Scene& scene, std::uint32_t index) {
  const SkinStatistics statistics = skin_statistics(scene, index);
  Json histogram = Json::object();
  for (const auto& [count, vertices] : statistics.vertices_by_influences) histogram[std::to_string(count)] = vertices;
  Json names = Json::array();
  for (const std::uint32_t joint : scene.skins[index].joints) names.push_back(scene.skeleton.names[joint]);
  return {{"name", scene.skins[index].name},
          {"joints", scene.skins[index].joints.size()},
          {"joint_names", names},
          {"joints_with_weight", statistics.joints_with_weight},
          {"root", index_or_null(node_of(scene, scene.skins[index].skeleton_root))},
          {"vertices_by_influences", histogram}};
}

std::uint64_t decoded_bytes(const Image& image) { return std::uint64_t{4} * image.width * image.height; }

Json image_json(const Image& image) {
  return {{"name", image.name},
          {"format", image.mime_type.empty() ? Json(nullptr) : Json(image.mime_type)},
          {"width", image.width},
          {"height", image.height},
          {"bytes", image.encoded_size},
          {"bytes_decoded", decoded_bytes(image)},
          {"missing", image.missing_reason.empty() ? Json(nullptr) : Json(image.missing_reason)}};
}

Json camera_json(const Scene& scene, const Camera& camera) {
  return {{"name", std::string(camera.name)},
          {"node", index_or_null(node_of(scene, camera.joint))},
          {"kind", camera.perspective ? "perspective" : "orthographic"},
          {"fov_y_rad", camera.perspective ? Json(camera.fov_y_rad) : Json(nullptr)},
          {"half_height", camera.perspective ? Json(nullptr) : Json(camera.half_height)},
          {"near_m", camera.near_m},
          {"far_m", camera.far_m > 0.0f ? Json(camera.far_m) : Json(nullptr)}};
}

Json light_json(const Scene& scene, const Light& light) {
  return {{"name", std::string(light.name)},
          {"node", index_or_null(node_of(scene, light.joint))},
          {"kind", name_of(light.kind, kLightNames)},
          {"color", {light.color.r, light.color.g, light.color.b}},
          {"intensity", light.intensity},
          {"range_m", light.range_m > 0.0f ? Json(light.range_m) : Json(nullptr)}};
}

Json extensions_json(const ImportedFile::Facts& facts) {
  constexpr const char* kWords[] = {"read", "read past", "unknown"};
  const auto holds = [](const std::vector<std::string>& list, const std::string& name) {
    return std::find(list.begin(), list.end(), name) != list.end();
  };
  std::vector<std::string> names = facts.extensions_used;
  for (const auto& name : facts.extensions_required)
    if (!holds(names, name)) names.push_back(name);
  Json out = Json::array();
  for (const auto& name : names)
    out.push_back({{"name", name},
                   {"required", holds(facts.extensions_required, name)},
                   {"handling", kWords[static_cast<std::size_t>(extension_support(name))]}});
  return out;
}

Json issue_json(const ImportIssue& issue) {
  return {{"rule", issue.rule}, {"pointer", issue.json_pointer}, {"message", issue.detail}, {"cases", issue.cases}};
}

/// The losses for which `sinew convert` needs --drop, or the error with which it fails.
std::vector<ImportIssue> lost_by_convert(const ImportedFile& file) {
  RewriteOptions options;
  options.drop = {"all"};
  options.buffer_uri = "any.bin";  // a document without its binary part is smaller
  auto written = rewrite_gltf(file, options);
  if (!written) return {written.error().issue};
  return std::move(written->drops);
}

/// A JSON array with `entry(element)` for each element of `list`.
template <class T, class Entry>
Json array_of(const std::vector<T>& list, const Entry& entry) {
  Json out = Json::array();
  for (const T& element : list) out.push_back(entry(element));
  return out;
}

/// The memory of the scene with decoded images. `sinew info` reads only the headers of images.
Json memory_with_images(const Scene& scene) {
  MemoryBytes bytes = memory_of(scene);
  for (const Image& image : scene.images) bytes.images += decoded_bytes(image);
  return memory_json(bytes);
}

}  // namespace

Json info_json(const std::string& name, const ImportedFile& file, const std::vector<ImportIssue>& not_carried) {
  const Scene& scene = file.scene;
  Json out = {{"file", name},
              {"bytes", file.facts.file_bytes},
              {"version", file.facts.version},
              {"generator", file.facts.generator},
              {"copyright", file.facts.copyright},
              {"extensions", extensions_json(file.facts)},
              {"nodes", nodes_json(scene.skeleton)},
              {"scenes", scene.scenes.size()},
              {"default_scene", index_or_null(scene.default_scene)},
              {"bounds", box_json(rest_box(scene))},
              {"memory", memory_with_images(scene)}};
  out["meshes"] = array_of(scene.meshes, mesh_json);
  out["mesh_instances"] = array_of(scene.instances, [&](const MeshInstance& i) { return instance_json(scene, i); });
  out["skins"] = Json::array();
  for (std::uint32_t s = 0; s < scene.skins.size(); ++s) out["skins"].push_back(skin_json(scene, s));
  out["clips"] = Json::array();
  for (std::size_t i = 0; i < scene.animations.size(); ++i)
    out["clips"].push_back(clip_json(scene, scene.animations[i], scene.clips[i]));
  out["hidden_nodes"] = array_of(scene.hidden_joints, [&](std::uint32_t joint) { return node_of(scene, joint); });
  out["variants"] = scene.variants;
  out["materials"] = array_of(scene.materials, [&](const Material& m) { return material_json(scene, m); });
  out["images"] = array_of(scene.images, image_json);
  out["cameras"] = array_of(scene.cameras, [&](const Camera& c) { return camera_json(scene, c); });
  out["lights"] = array_of(scene.lights, [&](const Light& l) { return light_json(scene, l); });
  if (file.vrm) out["vrm"] = vrm_json(*file.vrm, scene);
  out["warnings"] = array_of(file.warnings, issue_json);
  out["lost_by_convert"] =
      file.carried ? array_of(lost_by_convert(file), issue_json) : array_of(not_carried, issue_json);
  return out;
}

}  // namespace sinew::tool
