// SPDX-License-Identifier: MIT
#include "importer/file/document_size.h"

#include "importer/file/document.h"

namespace sinew {

std::uint64_t entry_bytes(const JsonNode& root) noexcept {
  constexpr struct {
    const char* name;
    std::uint64_t size;
  } kLists[] = {{"cameras", sizeof(tinygltf::Camera)},   {"materials", sizeof(gltf::Material)},
                {"meshes", sizeof(gltf::Mesh)},          {"nodes", sizeof(gltf::Node)},
                {"samplers", sizeof(tinygltf::Sampler)}, {"scenes", sizeof(tinygltf::Scene)},
                {"skins", sizeof(tinygltf::Skin)},       {"textures", sizeof(gltf::Texture)}};
  std::uint64_t bytes = 0;
  for (const auto& [name, size] : kLists)
    if (const JsonNode* list = find_member(root, name)) bytes += size * list->Size();
  if (const JsonNode* meshes = find_member(root, "meshes"))
    for (const JsonNode& mesh : meshes->GetArray())
      bytes += sizeof(gltf::Primitive) * find_member(mesh, "primitives")->Size();
  return bytes;
}

}  // namespace sinew
