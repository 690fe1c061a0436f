// SPDX-License-Identifier: MIT
#include <string>

#include "importer/write/write_scene.h"

namespace sinew::write {
namespace {

using Object = tinygltf::Value::Object;
using Array = tinygltf::Value::Array;

constexpr const char* kExtension = "KHR_materials_variants";

tinygltf::Value number(std::uint32_t index) { return tinygltf::Value(static_cast<int>(index)); }

}  // namespace

void write_variants(const Scene& scene, tinygltf::Model& model) {
  if (scene.variants.empty()) return;
  declare_extension(model, kExtension);
  Array names;
  for (const auto& name : scene.variants) names.emplace_back(Object{{"name", tinygltf::Value(name)}});
  model.extensions[kExtension] = tinygltf::Value(Object{{"variants", tinygltf::Value(std::move(names))}});
  for (std::size_t m = 0; m < scene.meshes.size(); ++m)
    for (std::size_t p = 0; p < scene.meshes[m].primitives.size(); ++p) {
      Array mappings;
      for (const VariantMaterial& other : scene.meshes[m].primitives[p].variant_materials)
        mappings.emplace_back(
            Object{{"material", number(other.material)}, {"variants", tinygltf::Value(Array{number(other.variant)})}});
      if (!mappings.empty())
        model.meshes[m].primitives[p].extensions[kExtension] =
            tinygltf::Value(Object{{"mappings", tinygltf::Value(std::move(mappings))}});
    }
}

}  // namespace sinew::write
