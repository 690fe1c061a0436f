// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "runtime/model/aabb.h"
#include "runtime/model/morph_set.h"
#include "runtime/model/skin.h"

namespace sinew {

/// Topology of an index list. The importer converts strips, fans and loops to plain lists.
enum class Topology : std::uint8_t { points, lines, triangles };

/// [clips][instances] Bounds of each mesh instance over the whole of each clip, computed by clip_boxes
/// (lod/clip_bounds.h) when the clips were compiled. An empty or missing list means that the bounds of that clip were
/// not computed. An empty box means that the bounds of that instance are unknown.
using ClipBoxes = std::vector<std::vector<Aabb>>;

/// The material of a primitive in one of the Scene::variants.
struct VariantMaterial {
  std::uint32_t variant = 0, material = 0;

  friend bool operator==(const VariantMaterial&, const VariantMaterial&) = default;
};

/// One draw call: vertex attributes as separate arrays of V entries each (an absent attribute is empty), an index list
/// and a material. The importer groups vertices by influence count; `source_vertex` gives the file's order.
struct Primitive {
  Topology topology = Topology::triangles;
  std::vector<std::uint32_t> indices;  ///< 1, 2 or 3 per point, line or triangle; always present, always < V
  std::vector<glm::vec3> positions;    ///< [V] metres, mesh space
  std::vector<glm::vec3> normals;      ///< [V] unit; the importer computes missing ones for triangles
  std::vector<glm::vec4> tangents;     ///< [V] unit xyz, w = handedness; only with texcoords and a normal map
  std::vector<std::vector<glm::vec2>> texcoords;
  std::vector<glm::vec4> colors;  ///< [V] vertex colours (COLOR_0), linear
  VertexInfluences influences;    ///< empty = not skinned
  /// [V] rest space, for Skinning::center_of_rotation; empty = none (importer/add_centers_of_rotation.h makes them)
  std::vector<glm::vec3> centers_of_rotation;
  MorphSet morphs;
  std::uint32_t material = kNone;
  std::vector<VariantMaterial> variant_materials;  ///< sorted by variant; other variants use `material`
  std::vector<std::uint32_t> source_vertex;        ///< [V] vertex index in the file; empty = unchanged
  bool flat_normals = false;  ///< the file has no normals: each face gets its own normal, computed again after morphing
  Aabb bounds;                ///< contains all positions

  std::size_t vertex_count() const noexcept { return positions.size(); }
};

/// The material of a primitive in a variant. variant = kNone gives Primitive::material.
inline std::uint32_t material_of(const Primitive& primitive, std::uint32_t variant) noexcept {
  for (const VariantMaterial& other : primitive.variant_materials)
    if (other.variant == variant) return other.material;
  return primitive.material;
}

struct Mesh {
  std::string name;
  std::vector<Primitive> primitives;
  std::vector<float> default_weights;     ///< [T] mesh.weights of the file, else zeros
  std::vector<std::string> target_names;  ///< [T] or empty; many exporters write them to extras.targetNames

  std::size_t target_count() const noexcept { return default_weights.size(); }
};

}  // namespace sinew
