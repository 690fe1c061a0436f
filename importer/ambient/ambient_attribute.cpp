// SPDX-License-Identifier: MIT
#include "importer/ambient/ambient_attribute.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "importer/ambient/bake_key_poses.h"
#include "importer/ambient/key_pose_names.h"
#include "importer/file/json_pointer.h"
#include "importer/read/accessor.h"
#include "importer/rewrite/carried_document.h"
#include "runtime/base/contract.h"

namespace sinew {
namespace {

using Attributes = std::map<std::string, int>;

std::uint32_t file_vertex(const Primitive& primitive, std::size_t vertex) {
  return primitive.source_vertex.empty() ? static_cast<std::uint32_t>(vertex) : primitive.source_vertex[vertex];
}

/// Converts values from scene vertex order to file order; a vertex that was split gets the mean of its copies.
std::vector<float> in_order_of_file(const Primitive& primitive, const std::vector<float>& visibility) {
  std::vector<double> sums;
  std::vector<std::uint32_t> copies;
  for (std::size_t v = 0; v < visibility.size(); ++v) {
    const std::uint32_t source = file_vertex(primitive, v);
    if (source >= sums.size()) sums.resize(source + std::size_t{1});
    copies.resize(sums.size());
    sums[source] += static_cast<double>(visibility[v]);
    ++copies[source];
  }
  std::vector<float> values(sums.size());
  for (std::size_t v = 0; v < values.size(); ++v) values[v] = static_cast<float>(sums[v] / std::max(copies[v], 1u));
  return values;
}

/// Checks an attribute: returns a warning if its values cannot be used.
std::optional<ImportIssue> fault_of(const gltf::Accessor& accessor, const std::vector<float>& values,
                                    std::size_t vertices, const std::string& place) {
  const auto warning = [&](const char* rule, const std::string& detail) {
    return ImportIssue{Severity::warning, rule, place, detail + "; ignored"};
  };
  if (accessor.type != gltf::ElementType::scalar)
    return warning("mesh-attribute-format", "ambient visibility is one number a vertex");
  if (values.size() < vertices)
    return warning("mesh-attribute-count",
                   std::to_string(values.size()) + " entries for " + std::to_string(vertices) + " vertices");
  const auto fraction = [](float value) { return value >= 0.0f && value <= 1.0f; };
  if (!std::all_of(values.begin(), values.end(), fraction))
    return warning("mesh-attribute-format", "ambient visibility lies between 0 and 1");
  return std::nullopt;
}

/// Visits each attribute of each primitive: (mesh, primitive, name).
template <typename Visit>
void for_each_attribute(const gltf::Document& document, const Visit& visit) {
  for (std::size_t m = 0; m < document.meshes.size(); ++m)
    for (std::size_t p = 0; p < document.meshes[m].primitives.size(); ++p)
      for (const auto& [name, accessor] : document.meshes[m].primitives[p].attributes) visit(m, p, name);
}

/// Finds the first clip with key poses and their number; does not read values yet.
VertexVisibility key_poses_in(const ImportedFile& file, std::vector<ImportIssue>& issues) {
  VertexVisibility visibility;
  std::uint32_t count = 1;
  std::set<std::uint32_t> unknown;
  const std::vector<Animation>& clips = file.scene.animations;
  for_each_attribute(file.carried->document, [&](std::size_t m, std::size_t p, const std::string& name) {
    const auto key = key_pose_named(name);
    if (!key) return;
    if (key->clip >= clips.size()) {
      if (unknown.insert(key->clip).second)
        issues.push_back({Severity::warning, "mesh-attribute-format",
                          pointer("meshes", m, "primitives", p, "attributes", name),
                          "ambient visibility of animation " + std::to_string(key->clip) + ", and there are " +
                              std::to_string(clips.size()) + "; ignored"});
      return;
    }
    if (key->clip > visibility.clip) return;
    count = key->clip < visibility.clip ? key->pose + 1 : std::max(count, key->pose + 1);
    visibility.clip = key->clip;
  });
  if (visibility.clip != kNone) visibility.times_s = key_pose_times(clips[visibility.clip].duration_s, count);
  return visibility;
}

/// The attributes with the key poses of a primitive, one for each pose.
std::vector<std::string> names_of_poses(const Attributes& attributes, const VertexVisibility& visibility) {
  std::vector<std::string> keyed, single;
  bool any = false;
  for (std::uint32_t k = 0; k < visibility.times_s.size(); ++k) {
    single.emplace_back(kAmbientVisibilityAttribute);
    keyed.push_back(name_of_key_pose({visibility.clip, k}));
    any |= attributes.count(keyed.back()) > 0;
  }
  return any ? keyed : single;
}

/// Reads one attribute, in scene vertex order.
/// out   empty if it cannot be used; the reason is added to `issues`
std::vector<float> read_attribute(const gltf::Document& document, const Primitive& primitive, int accessor,
                                  const std::string& place, std::vector<ImportIssue>& issues) {
  const std::vector<float> values = read_floats(document, accessor);
  std::uint32_t last = 0;
  for (std::size_t v = 0; v < primitive.vertex_count(); ++v) last = std::max(last, file_vertex(primitive, v));
  if (auto fault = fault_of(document.accessors[accessor], values, last + std::size_t{1}, place)) {
    issues.push_back(*std::move(fault));
    return {};
  }
  std::vector<float> visibility;
  for (std::size_t v = 0; v < primitive.vertex_count(); ++v) visibility.push_back(values[file_vertex(primitive, v)]);
  return visibility;
}

/// Reads all key poses of a primitive, concatenated; empty if any is missing or unusable.
std::vector<float> read_poses(const ImportedFile& file, std::size_t m, std::size_t p,
                              const VertexVisibility& visibility, std::vector<ImportIssue>& issues) {
  const gltf::Document& document = file.carried->document;
  const Primitive& primitive = file.scene.meshes[m].primitives[p];
  const Attributes& attributes = document.meshes[m].primitives[p].attributes;
  std::vector<float> all;
  for (const std::string& name : names_of_poses(attributes, visibility)) {
    const auto found = attributes.find(name);
    if (found == attributes.end() || primitive.positions.empty()) {
      if (name != kAmbientVisibilityAttribute)
        issues.push_back({Severity::warning, "mesh-attribute-count",
                          pointer("meshes", m, "primitives", p, "attributes"),
                          "key poses of ambient visibility without " + name + "; ignored"});
      return {};
    }
    const std::vector<float> pose = read_attribute(document, primitive, found->second,
                                                   pointer("meshes", m, "primitives", p, "attributes", name), issues);
    if (pose.empty()) return {};
    all.insert(all.end(), pose.begin(), pose.end());
  }
  return all;
}

/// Extracts the values of one key pose.
std::vector<float> pose_of(const std::vector<float>& values, std::size_t poses, std::size_t index) {
  const auto vertices = static_cast<std::ptrdiff_t>(values.size() / poses);
  const auto first = values.begin() + static_cast<std::ptrdiff_t>(index) * vertices;
  return {first, first + vertices};
}

}  // namespace

std::vector<AddedAttribute> ambient_attributes(const Scene& scene, const VertexVisibility& visibility) {
  std::vector<AddedAttribute> attributes;
  const std::size_t poses = visibility.times_s.size();
  for (std::uint32_t m = 0; m < visibility.values.size(); ++m)
    for (std::uint32_t p = 0; p < visibility.values[m].size(); ++p)
      for (std::uint32_t k = 0; k < poses && !visibility.values[m][p].empty(); ++k)
        attributes.push_back(
            {m, p, poses == 1 ? kAmbientVisibilityAttribute : name_of_key_pose({visibility.clip, k}),
             in_order_of_file(scene.meshes[m].primitives[p], pose_of(visibility.values[m][p], poses, k))});
  return attributes;
}

std::vector<std::string> ambient_attribute_names(const ImportedFile& file) {
  CONTRACT(file.carried != nullptr);
  std::set<std::string> names;
  for_each_attribute(file.carried->document, [&](std::size_t, std::size_t, const std::string& name) {
    if (name == kAmbientVisibilityAttribute || key_pose_named(name)) names.insert(name);
  });
  return {names.begin(), names.end()};
}

VertexVisibility read_ambient_visibility(const ImportedFile& file, std::vector<ImportIssue>& issues) {
  CONTRACT(file.carried != nullptr);
  VertexVisibility visibility = key_poses_in(file, issues);
  for (std::size_t m = 0; m < file.scene.meshes.size(); ++m) {
    auto& values = visibility.values.emplace_back();
    for (std::size_t p = 0; p < file.scene.meshes[m].primitives.size(); ++p)
      values.push_back(read_poses(file, m, p, visibility, issues));
  }
  return visibility;
}

}  // namespace sinew
