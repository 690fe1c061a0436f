// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include <nlohmann/json.hpp>

#include "importer/file/tinygltf.h"
#include "runtime/animation/property_track.h"  // TextureSlot
#include "runtime/animation/skeleton.h"        // kNone

/// The part of gltf::Document (document.h) that describes materials, textures and images.
namespace sinew::gltf {

using Json = nlohmann::json;
using Bytes = std::span<const std::byte>;

inline constexpr std::size_t kTextureSlots = 5;

struct Material : tinygltf::Material {
  Json extensions;                                     ///< hides tinygltf's member, which stays empty
  std::array<Json, kTextureSlots> texture_extensions;  ///< extensions of the texture info in each TextureSlot

  Json& extensions_of(TextureSlot slot) { return texture_extensions[static_cast<std::size_t>(slot)]; }
};

/// A texture reference of a material; unifies tinygltf's three types for the five slots.
struct TextureInfo {
  std::uint32_t index = kNone, texcoord = 0;
  const Json* extensions = nullptr;  ///< points into the material
};
TextureInfo texture_info(const Material& material, TextureSlot slot) noexcept;

struct Texture : tinygltf::Texture {
  Json extensions;  ///< hides tinygltf's member, which stays empty
};

/// An image in its encoded form; importer/read/images.h decodes it. A missing image is not an error.
struct Image {
  std::string name, uri, mime_type;
  std::uint32_t buffer_view = kNone;
  Bytes encoded;               ///< filled by load_images()
  std::string missing_reason;  ///< why `encoded` is empty; else empty
};

}  // namespace sinew::gltf
