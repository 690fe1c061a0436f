// SPDX-License-Identifier: MIT
#include "runtime/c/scene.h"

#include <algorithm>
#include <iterator>
#include <string_view>

#include "runtime/c/boundary.h"
#include "runtime/c/handles.h"

namespace {

using namespace sinew;
using c::span_from;

/// Element `i`, or nothing.
template <class T>
const T* at(const std::vector<T>& all, std::size_t i) noexcept {
  return i < all.size() ? &all[i] : nullptr;
}

/// Element `i` of one of the scene's arrays, or nothing.
template <class T>
const T* at(const sinew_scene* scene, std::vector<T> Scene::*all, std::size_t i) noexcept {
  return scene != nullptr ? at(scene->scene.*all, i) : nullptr;
}

template <class T>
std::size_t count_of(const sinew_scene* scene, std::vector<T> Scene::*all) noexcept {
  return scene != nullptr ? (scene->scene.*all).size() : 0;
}

sinew_string name_at(const std::vector<std::string>& names, std::size_t i) noexcept {
  const std::string* name = at(names, i);
  return name != nullptr ? c::string_from(*name) : sinew_string{"", 0};
}

template <class T>
std::uint32_t find_named(const std::vector<T>& all, const char* name, auto name_of) noexcept {
  if (name == nullptr) return SINEW_NONE;
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const T& one) { return std::string_view(name_of(one)) == name; });
  return found == all.end() ? SINEW_NONE : static_cast<std::uint32_t>(found - all.begin());
}

const std::string& clip_name(const Clip& clip) noexcept { return clip.name(); }
const std::string& mesh_name(const Mesh& mesh) noexcept { return mesh.name; }
const std::string& own_name(const std::string& name) noexcept { return name; }

const Primitive* primitive_at(const sinew_scene* scene, std::uint32_t mesh, std::uint32_t primitive) noexcept {
  const Mesh* found = at(scene, &Scene::meshes, mesh);
  return found != nullptr ? at(found->primitives, primitive) : nullptr;
}

}  // namespace

void sinew_scene_destroy(sinew_scene* scene) { delete scene; }

std::size_t sinew_joint_count(const sinew_scene* scene) {
  return scene != nullptr ? scene->scene.skeleton.joint_count() : 0;
}

sinew_string sinew_joint_name(const sinew_scene* scene, std::uint32_t joint) {
  return scene != nullptr ? name_at(scene->scene.skeleton.names, joint) : sinew_string{"", 0};
}

std::uint32_t sinew_joint_parent(const sinew_scene* scene, std::uint32_t joint) {
  const std::uint32_t* parent = scene != nullptr ? at(scene->scene.skeleton.parents, joint) : nullptr;
  return parent != nullptr ? *parent : SINEW_NONE;
}

std::uint32_t sinew_find_joint(const sinew_scene* scene, const char* name) {
  return scene != nullptr ? find_named(scene->scene.skeleton.names, name, own_name) : SINEW_NONE;
}

std::size_t sinew_clip_count(const sinew_scene* scene) { return count_of(scene, &Scene::clips); }

sinew_string sinew_clip_name(const sinew_scene* scene, std::uint32_t clip) {
  const Clip* found = at(scene, &Scene::clips, clip);
  return found != nullptr ? c::string_from(found->name()) : sinew_string{"", 0};
}

double sinew_clip_duration_s(const sinew_scene* scene, std::uint32_t clip) {
  const Clip* found = at(scene, &Scene::clips, clip);
  return found != nullptr ? found->duration_s() : 0.0;
}

std::uint32_t sinew_find_clip(const sinew_scene* scene, const char* name) {
  return scene != nullptr ? find_named(scene->scene.clips, name, clip_name) : SINEW_NONE;
}

std::size_t sinew_skin_count(const sinew_scene* scene) { return count_of(scene, &Scene::skins); }

sinew_indices sinew_skin_joints(const sinew_scene* scene, std::uint32_t skin) {
  const Skin* found = at(scene, &Scene::skins, skin);
  return found != nullptr ? sinew_indices{found->joints.data(), found->joints.size()} : sinew_indices{nullptr, 0};
}

std::size_t sinew_mesh_count(const sinew_scene* scene) { return count_of(scene, &Scene::meshes); }

sinew_string sinew_mesh_name(const sinew_scene* scene, std::uint32_t mesh) {
  const Mesh* found = at(scene, &Scene::meshes, mesh);
  return found != nullptr ? c::string_from(found->name) : sinew_string{"", 0};
}

std::uint32_t sinew_find_mesh(const sinew_scene* scene, const char* name) {
  return scene != nullptr ? find_named(scene->scene.meshes, name, mesh_name) : SINEW_NONE;
}

std::size_t sinew_primitive_count(const sinew_scene* scene, std::uint32_t mesh) {
  const Mesh* found = at(scene, &Scene::meshes, mesh);
  return found != nullptr ? found->primitives.size() : 0;
}

std::size_t sinew_target_count(const sinew_scene* scene, std::uint32_t mesh) {
  const Mesh* found = at(scene, &Scene::meshes, mesh);
  return found != nullptr ? found->target_count() : 0;
}

sinew_string sinew_target_name(const sinew_scene* scene, std::uint32_t mesh, std::uint32_t target) {
  const Mesh* found = at(scene, &Scene::meshes, mesh);
  return found != nullptr ? name_at(found->target_names, target) : sinew_string{"", 0};
}

std::size_t sinew_instance_count(const sinew_scene* scene) { return count_of(scene, &Scene::instances); }

std::size_t sinew_weight_count(const sinew_scene* scene) { return scene != nullptr ? scene->scene.weight_count() : 0; }

sinew_error sinew_get_instance(const sinew_scene* scene, std::uint32_t instance, sinew_instance* out) {
  if (scene == nullptr) return SINEW_NULL_ARGUMENT;
  const MeshInstance* found = at(scene, &Scene::instances, instance);
  if (found == nullptr) return SINEW_INDEX_OUT_OF_RANGE;
  const auto& first = scene->scene.first_weight;
  return c::write_struct({.struct_size = 0,
                          .joint = found->joint,
                          .mesh = found->mesh,
                          .skin = found->skin,
                          .first_weight = first[instance],
                          .weight_count = first[instance + 1] - first[instance]},
                         out);
}

sinew_error sinew_get_primitive(const sinew_scene* scene, std::uint32_t mesh, std::uint32_t primitive,
                                sinew_primitive* out) {
  if (scene == nullptr) return SINEW_NULL_ARGUMENT;
  const Primitive* found = primitive_at(scene, mesh, primitive);
  if (found == nullptr) return SINEW_INDEX_OUT_OF_RANGE;
  return c::write_struct({.struct_size = 0,
                          .topology = static_cast<std::uint32_t>(found->topology),
                          .material = found->material,
                          .indices = {found->indices.data(), found->indices.size()},
                          .positions = span_from<sinew_vec3s>(std::span(found->positions)),
                          .normals = span_from<sinew_vec3s>(std::span(found->normals)),
                          .tangents = span_from<sinew_vec4s>(std::span(found->tangents)),
                          .colors = span_from<sinew_vec4s>(std::span(found->colors)),
                          .texcoord_count = found->texcoords.size()},
                         out);
}

sinew_vec2s sinew_primitive_texcoords(const sinew_scene* scene, std::uint32_t mesh, std::uint32_t primitive,
                                      std::uint32_t set) {
  const Primitive* found = primitive_at(scene, mesh, primitive);
  const std::vector<glm::vec2>* texcoords = found != nullptr ? at(found->texcoords, set) : nullptr;
  return texcoords != nullptr ? span_from<sinew_vec2s>(std::span(*texcoords)) : sinew_vec2s{nullptr, 0};
}

sinew_influences sinew_vertex_influences(const sinew_scene* scene, std::uint32_t mesh, std::uint32_t primitive,
                                         std::uint32_t vertex) {
  const Primitive* found = primitive_at(scene, mesh, primitive);
  if (found == nullptr || found->influences.empty() || vertex >= found->vertex_count()) return {nullptr, nullptr, 0};
  const VertexInfluences& influences = found->influences;
  const auto group =
      std::prev(std::upper_bound(influences.groups.begin(), influences.groups.end(), vertex,
                                 [](std::uint32_t v, const InfluenceGroup& g) { return v < g.first_vertex; }));
  const std::size_t first = group->first_influence + std::size_t{vertex - group->first_vertex} * group->influence_count;
  return {&influences.joints[first], &influences.weights[first], group->influence_count};
}
