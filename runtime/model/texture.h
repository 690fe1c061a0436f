// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "runtime/animation/skeleton.h"

namespace sinew {

enum class Filter : std::uint8_t { nearest, linear };
enum class Wrap : std::uint8_t { repeat, clamp_to_edge, mirrored_repeat };

struct Sampler {
  Filter magnify = Filter::linear;
  Filter minify = Filter::linear;
  Filter mipmap = Filter::linear;
  bool use_mipmaps = true;
  Wrap wrap_u = Wrap::repeat;
  Wrap wrap_v = Wrap::repeat;
};

/// Decoded pixels, or the reason why the image is missing or unreadable. A missing image does not fail the import; a
/// visible placeholder is drawn instead.
struct Image {
  std::string name;
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> rgba;  ///< [4 * width * height] rows from the top; empty if only the header was read
  std::string missing_reason;      ///< not empty = the image is missing, so the placeholder is drawn
  std::string mime_type;           ///< from the content, such as "image/png"; empty if missing
  std::uint64_t encoded_size = 0;  ///< bytes in the file
  std::vector<std::byte> encoded;  ///< the bytes of the file, if the importer was asked to keep them
};

struct Texture {
  std::uint32_t image = kNone;
  Sampler sampler;
};

/// A texture as a material uses it.
/// eq   uv' = T(offset) * R(rotation) * S(scale) * uv   (KHR_texture_transform)
struct TextureUse {
  std::uint32_t texture = kNone;
  std::uint32_t texcoord = 0;
  glm::vec2 offset{0.0f};
  float rotation_rad = 0.0f;
  glm::vec2 scale{1.0f};

  bool used() const noexcept { return texture != kNone; }
};

}  // namespace sinew
