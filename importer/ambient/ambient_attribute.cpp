// SPDX-License-Identifier: MIT
#include "importer/ambient/ambient_attribute.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "importer/file/json_pointer.h"
#include "importer/read/accessor.h"
#include "importer/rewrite/carried_document.h"
#include "runtime/base/contract.h"

namespace sinew {
namespace {

std::uint32_t file_vertex(const Primitive& primitive, std::size_t vertex) {
  return primitive.source_vertex.empty() ? static_cast<std::uint32_t>(vertex) : primitive.source_vertex[vertex];
}

/// Values of the file's vertices from those of the scene's.
std::vector<float> in_order_of_file(const Primitive& primitive, const std::vector<float>& access) {
  std::vector<double> sums;
  std::vector<std::uint32_t> copies;
  for (std::size_t v = 0; v < access.size(); ++v) {
    const std::uint32_t source = file_vertex(primitive, v);
    if (source >= sums.size()) sums.resize(source + std::size_t{1});
    copies.resize(sums.size());
    sums[source] += static_cast<double>(access[v]);
    ++copies[source];
  }
  std::vector<float> values(sums.size());
  for (std::size_t v = 0; v < values.size(); ++v) values[v] = static_cast<float>(sums[v] / std::max(copies[v], 1u));
  return values;
}

/// What is wrong with an attribute; nothing when its values can be used.
std::optional<ImportIssue> fault_of(const gltf::Accessor& accessor, const std::vector<float>& values,
                                    std::size_t vertices, const std::string& place) {
  const auto warning = [&](const char* rule, const std::string& detail) {
    return ImportIssue{Severity::warning, rule, place, detail + "; ignored"};
  };
  if (accessor.type != gltf::ElementType::scalar)
    return warning("mesh-attribute-format", "ambient access is one number a vertex");
  if (values.size() < vertices)
    return warning("mesh-attribute-count",
                   std::to_string(values.size()) + " entries for " + std::to_string(vertices) + " vertices");
  const auto fraction = [](float value) { return value >= 0.0f && value <= 1.0f; };
  if (!std::all_of(values.begin(), values.end(), fraction))
    return warning("mesh-attribute-format", "ambient access lies between 0 and 1");
  return std::nullopt;
}

}  // namespace

std::vector<AddedAttribute> ambient_attributes(const Scene& scene, const MeshAccess& access) {
  std::vector<AddedAttribute> attributes;
  for (std::uint32_t m = 0; m < access.size(); ++m)
    for (std::uint32_t p = 0; p < access[m].size(); ++p)
      if (!access[m][p].empty())
        attributes.push_back(
            {m, p, kAmbientAccessAttribute, in_order_of_file(scene.meshes[m].primitives[p], access[m][p])});
  return attributes;
}

MeshAccess read_ambient_access(const ImportedFile& file, std::vector<ImportIssue>& issues) {
  CONTRACT(file.carried != nullptr);
  const gltf::Document& document = file.carried->document;
  MeshAccess access(file.scene.meshes.size());
  for (std::size_t m = 0; m < access.size(); ++m) {
    access[m].resize(file.scene.meshes[m].primitives.size());
    for (std::size_t p = 0; p < access[m].size(); ++p) {
      const Primitive& primitive = file.scene.meshes[m].primitives[p];
      const auto& attributes = document.meshes[m].primitives[p].attributes;
      const auto found = attributes.find(kAmbientAccessAttribute);
      if (found == attributes.end() || primitive.positions.empty()) continue;
      const std::vector<float> values = read_floats(document, found->second);
      std::uint32_t last = 0;
      for (std::size_t v = 0; v < primitive.vertex_count(); ++v) last = std::max(last, file_vertex(primitive, v));
      if (auto fault = fault_of(document.accessors[found->second], values, last + std::size_t{1},
                                pointer("meshes", m, "primitives", p, "attributes", kAmbientAccessAttribute))) {
        issues.push_back(*std::move(fault));
        continue;
      }
      for (std::size_t v = 0; v < primitive.vertex_count(); ++v)
        access[m][p].push_back(values[file_vertex(primitive, v)]);
    }
  }
  return access;
}

}  // namespace sinew
