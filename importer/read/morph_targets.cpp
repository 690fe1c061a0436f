// SPDX-License-Identifier: MIT
#include "importer/read/morph_targets.h"

#include <string>

#include "importer/file/json_pointer.h"
#include "importer/read/meshes.h"
#include "importer/read/vertex_formats.h"

namespace sinew {
namespace {

bool base_has(const Primitive& base, const Semantic& semantic) {
  switch (semantic.attribute) {
    case Attribute::position: return true;
    case Attribute::normal: return !base.normals.empty();
    case Attribute::tangent: return !base.tangents.empty();
    case Attribute::texcoord: return semantic.set < base.texcoords.size();
    case Attribute::color: return semantic.set == 0 && !base.colors.empty();
    case Attribute::joints:
    case Attribute::weights: break;
  }
  return false;
}

Displacements<glm::vec4> without_alpha(const Displacements<glm::vec3>& colors) {
  Displacements<glm::vec4> out{colors.indices, {}};
  out.values.reserve(colors.values.size());
  for (const auto& c : colors.values) out.values.emplace_back(c, 0.0f);
  return out;
}

/// Reads displacements. For a sparse accessor over zeros, reads only the replacements.
template <class V>
Displacements<V> read_displacements(const gltf::Document& document, std::uint32_t index, const std::string& place,
                                    IssueLog& log) {
  const gltf::Accessor& accessor = document.accessors[index];
  if (accessor.sparse.count == 0 || accessor.buffer_view != kNone)
    return {{}, read_finite<V>(document, index, place, log)};
  auto out = read_replacements<V>(document, index);
  if (accessor.component_type == gltf::ComponentType::f32 &&
      !check_finite<V>(out.values, out.indices, element_layout(accessor).components(), place, log))
    return {};
  return out;
}

}  // namespace

TargetData read_morph_target(const gltf::Document& document, std::uint32_t mesh, std::uint32_t primitive,
                             std::uint32_t target, const Primitive& base, IssueLog& log) {
  TargetData out;
  const auto& attributes = document.meshes[mesh].primitives[primitive].targets[target];
  for (const auto& [name, accessor] : attributes) {
    const std::string place = pointer("meshes", mesh, "primitives", primitive, "targets", target, pointer_token(name));
    const auto semantic = parse_semantic(name);
    if (!semantic) {
      if (!name.starts_with('_'))
        log.report(Rule::mesh_attribute_name, place, "is no attribute that glTF defines; ignored");
      continue;
    }
    if (!base_has(base, *semantic)) {
      log.report(Rule::morph_no_base, place, "displaces an attribute that the mesh does not have; ignored");
      continue;
    }
    if (document.accessors[accessor].count != base.vertex_count()) {
      log.report(Rule::mesh_attribute_count, place,
                 std::to_string(document.accessors[accessor].count) + " entries for " +
                     std::to_string(base.vertex_count()) + " vertices");
      continue;
    }
    if (!check_vertex_format(document, accessor, semantic->attribute, true, place, log)) continue;
    if (semantic->attribute == Attribute::texcoord)
      log.report(Rule::morph_texcoord, place, "texture coordinates stay as they are when the mesh is morphed");
    const auto vec3 = [&, accessor = accessor] {  // clang before 16 cannot capture structured bindings
      return read_displacements<glm::vec3>(document, accessor, place, log);
    };
    switch (semantic->attribute) {
      case Attribute::position: out.positions = vec3(); break;
      case Attribute::normal: out.normals = vec3(); break;
      case Attribute::tangent: out.tangents = vec3(); break;
      case Attribute::color:
        out.colors = document.accessors[accessor].type == gltf::ElementType::vec4
                         ? read_displacements<glm::vec4>(document, accessor, place, log)
                         : without_alpha(vec3());
        break;
      case Attribute::texcoord:
        if (out.texcoords.size() <= semantic->set) out.texcoords.resize(semantic->set + 1);
        out.texcoords[semantic->set] = read_displacements<glm::vec2>(document, accessor, place, log);
        break;
      case Attribute::joints:
      case Attribute::weights: break;
    }
  }
  return out;
}

}  // namespace sinew
