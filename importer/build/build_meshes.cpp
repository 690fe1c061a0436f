// SPDX-License-Identifier: MIT
#include "importer/build/build_meshes.h"

#include <algorithm>
#include <string>
#include <utility>

#include "importer/build/build_morph_sets.h"
#include "importer/build/group_vertices.h"
#include "importer/file/json_pointer.h"
#include "importer/read/json_member.h"
#include "importer/read/variants.h"
#include "importer/topology/normals.h"
#include "importer/topology/tangents.h"
#include "runtime/math/negligible.h"

namespace sinew {
namespace {

/// For each mesh, the joint count of the smallest skin used with it. All joint indices of the mesh must be below this.
std::vector<std::uint32_t> joint_limits(const gltf::Document& document) {
  std::vector<std::uint32_t> limits(document.meshes.size(), 65536);
  for (const auto& node : document.nodes)
    if (node.mesh != gltf::kAbsent && node.skin != gltf::kAbsent)
      limits[node.mesh] =
          std::min(limits[node.mesh], static_cast<std::uint32_t>(document.skins[node.skin].joints.size()));
  return limits;
}

std::size_t target_count(const gltf::Document& document, std::uint32_t mesh, IssueLog& log) {
  const auto& primitives = document.meshes[mesh].primitives;
  std::size_t most = 0;
  for (const auto& primitive : primitives) most = std::max(most, primitive.targets.size());
  for (std::size_t p = 1; p < primitives.size(); ++p)
    if (primitives[p].targets.size() != primitives[0].targets.size())
      log.report(Rule::mesh_target_count, pointer("meshes", mesh, "primitives", p, "targets"),
                 std::to_string(primitives[p].targets.size()) + " targets, the first primitive has " +
                     std::to_string(primitives[0].targets.size()) + "; missing ones move nothing");
  return most;
}

/// The texture coordinate set of a material's normal map; kNone if it has none.
std::uint32_t normal_map_texcoord(const gltf::Document& document, std::uint32_t material) {
  if (material == kNone) return kNone;
  const gltf::TextureInfo info = texture_info(document.materials[material], TextureSlot::normal);
  if (info.index == kNone) return kNone;
  const gltf::Json* own = member(member(info.extensions, "KHR_texture_transform"), "texCoord");
  return own != nullptr && own->is_number_unsigned() ? own->get<std::uint32_t>() : info.texcoord;
}

/// The texture coordinate set for a primitive's tangents: that of its own material's normal map, else of the first
/// variant with a normal map.
std::uint32_t normal_map_texcoord(const gltf::Document& document, const Primitive& primitive) {
  std::uint32_t set = normal_map_texcoord(document, primitive.material);
  for (const VariantMaterial& other : primitive.variant_materials)
    if (set == kNone) set = normal_map_texcoord(document, other.material);
  return set;
}

void make_missing(const gltf::Document& document, const ImportOptions& options, Primitive& primitive) {
  if (options.make_normals && primitive.normals.empty()) make_flat_normals(primitive);
  if (options.make_tangents && primitive.tangents.empty())
    make_tangents(primitive, normal_map_texcoord(document, primitive));
}

Primitive build_primitive(const gltf::Document& document, std::uint32_t mesh, std::uint32_t index, std::size_t targets,
                          std::uint32_t joint_limit, const ImportOptions& options, IssueLog& log) {
  const std::size_t errors = log.error_count();
  const auto broken = [&] { return log.error_count() != errors; };
  PrimitiveData data = read_primitive(document, mesh, index, log);
  Primitive& primitive = data.primitive;
  if (broken()) return {};
  const std::string place = pointer("meshes", mesh, "primitives", index, "attributes");
  auto merged = merge_influences(data.influence_sets, primitive.vertex_count(), joint_limit, place, log);
  if (broken()) return {};
  data.influence_sets.clear();
  group_vertices(primitive, std::move(merged));
  build_morph_set(document, mesh, index, targets, primitive, log);
  primitive.variant_materials = read_variant_materials(document, mesh, index, log);
  for (const auto& p : primitive.positions) primitive.bounds.add(p);
  if (broken()) return {};
  make_missing(document, options, primitive);
  return std::move(primitive);
}

std::vector<float> default_weights(const gltf::Mesh& mesh, std::uint32_t index, std::size_t targets, IssueLog& log) {
  if (!mesh.weights.empty() && mesh.weights.size() != targets)
    log.report(Rule::mesh_weights_count, pointer("meshes", index, "weights"),
               std::to_string(mesh.weights.size()) + " weights for " + std::to_string(targets) +
                   " targets; cut or filled with zeros");
  std::vector<float> weights(targets, 0.0f);
  for (std::size_t t = 0; t < std::min(targets, mesh.weights.size()); ++t)
    weights[t] = flushed(static_cast<float>(mesh.weights[t]));
  return weights;
}

/// Number of texture coordinate sets that a material needs: its highest set plus one; 0 without textures.
std::size_t needed_sets(const Material& material) {
  std::size_t needed = 0;
  for (const TextureUse* use : texture_uses(material))
    if (use->used()) needed = std::max(needed, std::size_t{use->texcoord} + 1);
  return needed;
}

/// Number of texture coordinate sets that a primitive needs, for its own material and those of all variants.
std::size_t needed_sets(const Scene& scene, const Primitive& primitive) {
  std::size_t needed = primitive.material == kNone ? 0 : needed_sets(scene.materials[primitive.material]);
  for (const VariantMaterial& other : primitive.variant_materials)
    if (other.material != kNone) needed = std::max(needed, needed_sets(scene.materials[other.material]));
  return needed;
}

}  // namespace

std::vector<Mesh> build_meshes(const gltf::Document& document, const ImportOptions& options, IssueLog& log) {
  std::vector<Mesh> meshes;
  meshes.reserve(document.meshes.size());
  const auto limits = joint_limits(document);
  for (std::uint32_t m = 0; m < document.meshes.size(); ++m) {
    const gltf::Mesh& source = document.meshes[m];
    Mesh mesh;
    mesh.name = source.name;
    const std::size_t targets = target_count(document, m, log);
    mesh.default_weights = default_weights(source, m, targets, log);
    if (source.target_names.size() == targets) mesh.target_names = source.target_names;
    for (std::uint32_t p = 0; p < source.primitives.size(); ++p)
      mesh.primitives.push_back(build_primitive(document, m, p, targets, limits[m], options, log));
    meshes.push_back(std::move(mesh));
    if (options.progress)
      options.progress("meshes", 0.35 + 0.3 * static_cast<double>(m + 1) / static_cast<double>(document.meshes.size()));
  }
  return meshes;
}

void check_texcoords(const Scene& scene, IssueLog& log) {
  for (std::size_t m = 0; m < scene.meshes.size(); ++m)
    for (std::size_t p = 0; p < scene.meshes[m].primitives.size(); ++p) {
      const Primitive& primitive = scene.meshes[m].primitives[p];
      if (primitive.positions.empty()) continue;
      if (const std::size_t needed = needed_sets(scene, primitive); needed > primitive.texcoords.size())
        log.report(Rule::mesh_texcoord_missing, pointer("meshes", m, "primitives", p, "material"),
                   "its textures use TEXCOORD_" + std::to_string(needed - 1) + ", the mesh has " +
                       std::to_string(primitive.texcoords.size()) + " sets; 0 0 is used");
    }
}

}  // namespace sinew
