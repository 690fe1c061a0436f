// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include <nlohmann/json.hpp>

#include "runtime/animation/skeleton.h"  // kNone

/// The part of gltf::Document (document.h) that describes how surfaces look.
namespace sinew::gltf {

using Json = nlohmann::json;
using Bytes = std::span<const std::byte>;

struct TextureInfo {
  std::uint32_t index = kNone, texcoord = 0;
  Json extensions;
};

struct Material {
  std::string name;
  std::array<double, 4> base_color{1, 1, 1, 1};
  double metallic = 1, roughness = 1, normal_scale = 1, occlusion_strength = 1, alpha_cutoff = 0.5;
  std::array<double, 3> emissive{0, 0, 0};
  TextureInfo base_color_texture, metallic_roughness_texture, normal_texture, occlusion_texture, emissive_texture;
  std::string alpha_mode = "OPAQUE";
  bool double_sided = false;
  Json extensions;
};

struct Texture {
  std::string name;
  std::uint32_t source = kNone, sampler = kNone;
  Json extensions;
};

/// An image in its encoded form; importer/read/images.h decodes it. A missing image is no error (G66).
struct Image {
  std::string name, uri, mime_type;
  std::uint32_t buffer_view = kNone;
  Bytes encoded;               ///< filled by load_images()
  std::string missing_reason;  ///< why `encoded` is empty; empty where it is not
};

struct TextureSampler {
  int mag_filter = -1, min_filter = -1;  ///< GL numbers, -1 = absent
  int wrap_s = 10497, wrap_t = 10497;
};

}  // namespace sinew::gltf
