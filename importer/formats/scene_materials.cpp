// SPDX-License-Identifier: MIT
#include <cmath>
#include <string>
#include <utility>

#include <assimp/material.h>

#include "importer/formats/scene_draft.h"

namespace sinew::formats {
namespace {

double part_of_one(float value) { return std::isfinite(value) ? glm::clamp(double{value}, 0.0, 1.0) : 1.0; }

/// Colours only: of textures, glTF wants the bytes, and files mostly name places on another machine.
tinygltf::Material colours_of(const aiMaterial& from) {
  tinygltf::Material to;
  aiString name;
  aiColor4D color(1.0f, 1.0f, 1.0f, 1.0f), emissive(0.0f, 0.0f, 0.0f, 1.0f);
  float opacity = 1.0f, shininess = 0.0f;
  int two_sided = 0;
  if (from.Get(AI_MATKEY_NAME, name) == AI_SUCCESS) to.name = text_of(name);
  from.Get(AI_MATKEY_COLOR_DIFFUSE, color);
  from.Get(AI_MATKEY_COLOR_EMISSIVE, emissive);
  from.Get(AI_MATKEY_OPACITY, opacity);
  from.Get(AI_MATKEY_SHININESS, shininess);
  from.Get(AI_MATKEY_TWOSIDED, two_sided);
  const double alpha = part_of_one(opacity);
  to.pbrMetallicRoughness.baseColorFactor = {part_of_one(color.r), part_of_one(color.g), part_of_one(color.b), alpha};
  to.pbrMetallicRoughness.metallicFactor = 0.0;
  // Exponent of Blinn and Phong as a roughness (Walter et al. 2007).
  to.pbrMetallicRoughness.roughnessFactor = shininess > 0.0f ? std::sqrt(std::sqrt(2.0 / (shininess + 2.0))) : 1.0;
  to.emissiveFactor = {part_of_one(emissive.r), part_of_one(emissive.g), part_of_one(emissive.b)};
  if (alpha < 1.0) to.alphaMode = "BLEND";
  to.doubleSided = two_sided != 0;
  return to;
}

}  // namespace

int material_of(unsigned index, SceneDraft& scene) {
  if (index >= scene.scene.mNumMaterials) return -1;
  const aiMaterial& from = *scene.scene.mMaterials[index];
  const auto [found, is_new] =
      scene.material_of_source.try_emplace(index, static_cast<int>(scene.draft.model.materials.size()));
  if (!is_new) return found->second;
  tinygltf::Material to = colours_of(from);
  unsigned textures = 0;
  for (int type = aiTextureType_DIFFUSE; type <= AI_TEXTURE_TYPE_MAX; ++type)
    textures += from.GetTextureCount(static_cast<aiTextureType>(type));
  if (textures != 0)
    scene.out.left_out.push_back(std::to_string(textures) + " textures of the material '" + to.name + "'");
  scene.draft.model.materials.push_back(std::move(to));
  return found->second;
}

}  // namespace sinew::formats
