// SPDX-License-Identifier: MIT
#include "importer/file/document_materials.h"

namespace sinew::gltf {

TextureInfo texture_info(const Material& material, TextureSlot slot) noexcept {
  const auto& surface = material.pbrMetallicRoughness;
  const auto info = [&](const auto& texture) {
    return TextureInfo{static_cast<std::uint32_t>(texture.index), static_cast<std::uint32_t>(texture.texCoord),
                       &material.texture_extensions[static_cast<std::size_t>(slot)]};
  };
  switch (slot) {
    case TextureSlot::base_color: return info(surface.baseColorTexture);
    case TextureSlot::metallic_roughness: return info(surface.metallicRoughnessTexture);
    case TextureSlot::normal: return info(material.normalTexture);
    case TextureSlot::occlusion: return info(material.occlusionTexture);
    case TextureSlot::emissive: break;
  }
  return info(material.emissiveTexture);
}

}  // namespace sinew::gltf
