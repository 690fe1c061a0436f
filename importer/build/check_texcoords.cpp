// SPDX-License-Identifier: MIT
#include "importer/build/check_texcoords.h"

#include <algorithm>
#include <string>

#include "importer/file/json_pointer.h"

namespace sinew {
namespace {

/// The highest set that the textures of a material need, plus one; 0 without textures.
std::size_t needed_sets(const Material& material) {
  std::size_t needed = 0;
  for (const TextureUse* use : {&material.base_color_texture, &material.metallic_roughness_texture,
                                &material.normal_texture, &material.occlusion_texture, &material.emissive_texture})
    if (use->used()) needed = std::max(needed, std::size_t{use->texcoord} + 1);
  return needed;
}

/// The same of a primitive: with its own material, and with that of each variant.
std::size_t needed_sets(const Scene& scene, const Primitive& primitive) {
  std::size_t needed = primitive.material == kNone ? 0 : needed_sets(scene.materials[primitive.material]);
  for (const VariantMaterial& other : primitive.variant_materials)
    if (other.material != kNone) needed = std::max(needed, needed_sets(scene.materials[other.material]));
  return needed;
}

}  // namespace

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
