// SPDX-License-Identifier: MIT
#include "runtime/c/scene.h"

#include <algorithm>
#include <cstring>
#include <functional>
#include <iterator>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

#include "runtime/c/glue/call.h"
#include "runtime/c/glue/enums.h"
#include "runtime/c/glue/fields.h"
#include "runtime/c/handles.h"

namespace {

using namespace sinew;

constexpr sinew_string kNoName{"", 0};

/// One of the scene's arrays, at the end of the member path; null without a scene.
template <auto... Path>
const auto* array_of(const sinew_scene* scene) noexcept {
  return scene != nullptr ? &c::member_of<&sinew_scene::scene, Path...>(*scene) : nullptr;
}

template <class T>
std::size_t size_of(const std::vector<T>* all) noexcept {
  return all != nullptr ? all->size() : 0;
}

/// Element `i`, or null.
template <class T>
const T* at(const std::vector<T>* all, std::size_t i) noexcept {
  return i < size_of(all) ? &(*all)[i] : nullptr;
}

/// Converts `get(object)` to C; `none` if there is no object.
template <class OfC, class Object>
OfC ask(const Object* object, auto get, OfC none) noexcept {
  if (object == nullptr) return none;
  return c::to_c(std::invoke(get, *object));
}

/// Index of the first element for which `get` returns the name.
template <class T>
std::uint32_t find_named(const std::vector<T>* all, const char* name, auto get) noexcept {
  if (all == nullptr || name == nullptr) return SINEW_NONE;
  const auto found = std::find_if(all->begin(), all->end(),
                                  [&](const T& one) { return std::string_view(std::invoke(get, one)) == name; });
  return found == all->end() ? SINEW_NONE : static_cast<std::uint32_t>(found - all->begin());
}

const std::vector<std::string>* joint_names(const sinew_scene* scene) noexcept {
  return array_of<&Scene::skeleton, &Skeleton::names>(scene);
}
const Clip* clip_at(const sinew_scene* scene, std::uint32_t clip) noexcept {
  return at(array_of<&Scene::clips>(scene), clip);
}
const NamedCurve* curve_at(const sinew_scene* scene, std::uint32_t clip, std::uint32_t curve) noexcept {
  const Clip* found = clip_at(scene, clip);
  return found == nullptr || curve >= found->annotations().curves.size() ? nullptr
                                                                         : &found->annotations().curves[curve];
}
sinew_string text_of(const std::string& text) noexcept { return {text.data(), text.size()}; }
const Mesh* mesh_at(const sinew_scene* scene, std::uint32_t mesh) noexcept {
  return at(array_of<&Scene::meshes>(scene), mesh);
}
const Primitive* primitive_at(const sinew_scene* scene, std::uint32_t mesh, std::uint32_t primitive) noexcept {
  const Mesh* found = mesh_at(scene, mesh);
  return found != nullptr ? at(&found->primitives, primitive) : nullptr;
}

}  // namespace

void sinew_scene_destroy(sinew_scene* scene) { delete scene; }

std::size_t sinew_joint_count(const sinew_scene* scene) {
  return size_of(array_of<&Scene::skeleton, &Skeleton::parents>(scene));
}

sinew_string sinew_joint_name(const sinew_scene* scene, std::uint32_t joint) {
  return ask(at(joint_names(scene), joint), std::identity(), kNoName);
}

std::uint32_t sinew_joint_parent(const sinew_scene* scene, std::uint32_t joint) {
  return ask(at(array_of<&Scene::skeleton, &Skeleton::parents>(scene), joint), std::identity(), SINEW_NONE);
}

std::uint32_t sinew_find_joint(const sinew_scene* scene, const char* name) {
  return find_named(joint_names(scene), name, std::identity());
}

std::size_t sinew_clip_count(const sinew_scene* scene) { return size_of(array_of<&Scene::clips>(scene)); }

sinew_string sinew_clip_name(const sinew_scene* scene, std::uint32_t clip) {
  return ask(clip_at(scene, clip), &Clip::name, kNoName);
}

double sinew_clip_duration_s(const sinew_scene* scene, std::uint32_t clip) {
  return ask(clip_at(scene, clip), &Clip::duration_s, 0.0);
}

sinew_doubles sinew_clip_event_times(const sinew_scene* scene, std::uint32_t clip) {
  const Clip* found = clip_at(scene, clip);
  if (found == nullptr) return {nullptr, 0};
  const std::vector<double>& times = found->annotations().event_times_s;
  return {times.data(), times.size()};
}

sinew_string sinew_clip_event_name(const sinew_scene* scene, std::uint32_t clip, std::uint32_t event) {
  const Clip* found = clip_at(scene, clip);
  if (found == nullptr || event >= found->annotations().event_names.size()) return kNoName;
  return text_of(found->annotations().event_names[event]);
}

std::size_t sinew_clip_curve_count(const sinew_scene* scene, std::uint32_t clip) {
  const Clip* found = clip_at(scene, clip);
  return found == nullptr ? 0 : found->annotations().curves.size();
}

sinew_string sinew_clip_curve_name(const sinew_scene* scene, std::uint32_t clip, std::uint32_t curve) {
  const NamedCurve* found = curve_at(scene, clip, curve);
  return found == nullptr ? kNoName : text_of(found->name);
}

std::size_t sinew_clip_curve_value(const sinew_scene* scene, std::uint32_t clip, std::uint32_t curve, double time_s,
                                   float* value) {
  const NamedCurve* found = curve_at(scene, clip, curve);
  if (found == nullptr || value == nullptr) return 0;
  return std::visit(
      [&]<class V>(const std::vector<CurveKey<V>>& keys) -> std::size_t {
        const V sampled = sample(Curve<V>(keys), time_s);
        if constexpr (std::is_arithmetic_v<V>) {
          *value = static_cast<float>(sampled);
          return 1;
        } else {
          std::memcpy(value, &sampled, sizeof sampled);
          return sizeof sampled / sizeof(float);
        }
      },
      found->keys);
}

std::uint32_t sinew_find_clip(const sinew_scene* scene, const char* name) {
  return find_named(array_of<&Scene::clips>(scene), name, &Clip::name);
}

std::size_t sinew_skin_count(const sinew_scene* scene) { return size_of(array_of<&Scene::skins>(scene)); }

sinew_indices sinew_skin_joints(const sinew_scene* scene, std::uint32_t skin) {
  return ask(at(array_of<&Scene::skins>(scene), skin), &Skin::joints, sinew_indices{nullptr, 0});
}

std::size_t sinew_mesh_count(const sinew_scene* scene) { return size_of(array_of<&Scene::meshes>(scene)); }

sinew_string sinew_mesh_name(const sinew_scene* scene, std::uint32_t mesh) {
  return ask(mesh_at(scene, mesh), &Mesh::name, kNoName);
}

std::uint32_t sinew_find_mesh(const sinew_scene* scene, const char* name) {
  return find_named(array_of<&Scene::meshes>(scene), name, &Mesh::name);
}

std::size_t sinew_primitive_count(const sinew_scene* scene, std::uint32_t mesh) {
  const Mesh* found = mesh_at(scene, mesh);
  return found != nullptr ? found->primitives.size() : 0;
}

std::size_t sinew_target_count(const sinew_scene* scene, std::uint32_t mesh) {
  const Mesh* found = mesh_at(scene, mesh);
  return found != nullptr ? found->target_count() : 0;
}

sinew_string sinew_target_name(const sinew_scene* scene, std::uint32_t mesh, std::uint32_t target) {
  const Mesh* found = mesh_at(scene, mesh);
  return found != nullptr ? ask(at(&found->target_names, target), std::identity(), kNoName) : kNoName;
}

std::size_t sinew_instance_count(const sinew_scene* scene) { return size_of(array_of<&Scene::instances>(scene)); }

std::size_t sinew_weight_count(const sinew_scene* scene) { return scene != nullptr ? scene->scene.weight_count() : 0; }

sinew_error sinew_get_instance(const sinew_scene* scene, std::uint32_t instance, sinew_instance* out) {
  return c::call(c::given(scene), [&] {
    const MeshInstance* found = at(array_of<&Scene::instances>(scene), instance);
    if (found == nullptr) return SINEW_INDEX_OUT_OF_RANGE;
    const auto& first = scene->scene.first_weight;
    return c::write_struct({.struct_size = 0,
                            .joint = found->joint,
                            .mesh = found->mesh,
                            .skin = found->skin,
                            .first_weight = first[instance],
                            .weight_count = first[instance + 1] - first[instance]},
                           out);
  });
}

sinew_error sinew_get_primitive(const sinew_scene* scene, std::uint32_t mesh, std::uint32_t primitive,
                                sinew_primitive* out) {
  return c::call(c::given(scene), [&] {
    const Primitive* found = primitive_at(scene, mesh, primitive);
    if (found == nullptr) return SINEW_INDEX_OUT_OF_RANGE;
    return c::write_struct({.struct_size = 0,
                            .topology = c::to_c(found->topology),
                            .material = found->material,
                            .indices = c::to_c(found->indices),
                            .positions = c::to_c(found->positions),
                            .normals = c::to_c(found->normals),
                            .tangents = c::to_c(found->tangents),
                            .colors = c::to_c(found->colors),
                            .texcoord_count = found->texcoords.size()},
                           out);
  });
}

sinew_vec2s sinew_primitive_texcoords(const sinew_scene* scene, std::uint32_t mesh, std::uint32_t primitive,
                                      std::uint32_t set) {
  const Primitive* found = primitive_at(scene, mesh, primitive);
  return ask(found != nullptr ? at(&found->texcoords, set) : nullptr, std::identity(), sinew_vec2s{nullptr, 0});
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
