// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "importer/file/document_animations.h"
#include "importer/file/document_materials.h"
#include "importer/file/tinygltf.h"

/// A parsed glTF 2.0 document as plain data: the content of the file with defaults filled in, not interpreted. The rest
/// of the importer reads this instead of JSON. Scenes, nodes, meshes, skins, cameras and materials extend tinygltf's
/// types. Buffers, views, accessors, images and animations have their own types. The reason: tinygltf would load the
/// bytes, stores some sizes as int, drops channels without a node, and takes five times the memory for a channel.
/// Indices are those of the file; kNone = absent. After check_references() (importer/file/check_references.h) every
/// index is in range. `extensions` members hold the JSON object of that name; null if absent.
namespace sinew::gltf {

enum class ComponentType : std::uint16_t { i8 = 5120, u8 = 5121, i16 = 5122, u16 = 5123, u32 = 5125, f32 = 5126 };
enum class ElementType : std::uint8_t { scalar, vec2, vec3, vec4, mat2, mat3, mat4 };
/// Values equal those of glTF and tinygltf.
enum class PrimitiveMode : std::uint8_t {
  points,
  lines,
  line_loop,
  line_strip,
  triangles,
  triangle_strip,
  triangle_fan
};

struct Buffer {
  std::string uri;  ///< empty for the BIN chunk of a .glb and for placeholders; cleared once the bytes are read
  std::uint64_t byte_length = 0;
  bool placeholder = false;  ///< has no bytes: it is missing, or a fallback of EXT_meshopt_compression
  Json extensions;
  Bytes bytes;  ///< filled by load_buffers(): byte_length bytes
};

struct BufferView {
  std::uint32_t buffer = kNone;
  std::uint64_t byte_offset = 0, byte_length = 0;
  std::uint32_t byte_stride = 0;  ///< 0 = tightly packed
  Json extensions;
  Bytes bytes;  ///< filled by load_buffers(), or by the decoder of a compression extension
};

struct SparseAccessor {
  std::uint64_t count = 0;  ///< 0 = not sparse
  std::uint32_t indices_view = kNone, values_view = kNone;
  std::uint64_t indices_offset = 0, values_offset = 0;
  ComponentType index_type = ComponentType::u32;
};

struct Accessor {
  std::uint32_t buffer_view = kNone;  ///< kNone = zeros, then replaced by sparse entries
  std::uint64_t byte_offset = 0, count = 0;
  ComponentType component_type = ComponentType::f32;
  ElementType type = ElementType::scalar;
  bool normalized = false;
  SparseAccessor sparse;
  std::vector<double> min, max;
};

/// Absent index in tinygltf's types; equals kNone when converted to unsigned.
inline constexpr int kAbsent = -1;

struct Primitive : tinygltf::Primitive {
  Primitive() { mode = TINYGLTF_MODE_TRIANGLES; }

  Json extensions;  ///< hides tinygltf's member, which stays empty
};

inline PrimitiveMode mode_of(const Primitive& primitive) noexcept { return static_cast<PrimitiveMode>(primitive.mode); }

struct Mesh : tinygltf::Mesh {
  std::vector<Primitive> primitives;      ///< hides tinygltf's member, which stays empty
  std::vector<std::string> target_names;  ///< from extras.targetNames
};

struct Node : tinygltf::Node {
  /// Has translation, rotation or scale in the file; tinygltf drops these if there is also a matrix.
  bool has_trs = false;
  Json extensions;  ///< hides tinygltf's member, which stays empty
};

/// Near and far distance of a camera; 0 = absent.
struct DepthRange {
  double near = 0.0, far = 0.0;
};
inline DepthRange depth_range(const tinygltf::Camera& camera) noexcept {
  const bool orthographic = camera.type == "orthographic";
  return orthographic ? DepthRange{camera.orthographic.znear, camera.orthographic.zfar}
                      : DepthRange{camera.perspective.znear, camera.perspective.zfar};
}

struct Document {
  tinygltf::Asset asset;
  std::vector<std::string> extensions_used, extensions_required;
  std::vector<Buffer> buffers;
  std::vector<BufferView> buffer_views;
  std::vector<Accessor> accessors;
  std::vector<Mesh> meshes;
  std::vector<Node> nodes;
  std::vector<tinygltf::Skin> skins;
  std::vector<Animation> animations;
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::vector<Image> images;
  std::vector<tinygltf::Sampler> samplers;
  std::vector<tinygltf::Camera> cameras;
  std::vector<tinygltf::Scene> scenes;
  std::uint32_t scene = kNone;
  Json extensions;  ///< extensions of the root object, such as KHR_lights_punctual

  /// Owns the memory that `Bytes` members point into, except the file itself: external files, data URIs, decoded views.
  /// A deque, because its entries do not move when it grows.
  std::deque<std::vector<std::byte>> storage;
};

}  // namespace sinew::gltf
