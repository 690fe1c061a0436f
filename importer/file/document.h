// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "importer/file/document_animations.h"
#include "importer/file/document_materials.h"

/// A parsed glTF 2.0 document as plain data: what the file says, with defaults filled in and nothing interpreted. The
/// rest of the importer reads this instead of the JSON. Indices are the file's own, kNone where absent. After
/// check_references() (importer/file/check_references.h) every index is in range. `extensions` members hold the JSON
/// object of that name, null where there is none.
namespace sinew::gltf {

enum class ComponentType : std::uint16_t { i8 = 5120, u8 = 5121, i16 = 5122, u16 = 5123, u32 = 5125, f32 = 5126 };
enum class ElementType : std::uint8_t { scalar, vec2, vec3, vec4, mat2, mat3, mat4 };
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
  bool placeholder = false;  ///< has no bytes: the fallback of EXT_meshopt_compression (T6), or missing
  Json extensions;
  Bytes bytes;  ///< filled by load_buffers(): byte_length bytes
};

struct BufferView {
  std::uint32_t buffer = kNone;
  std::uint64_t byte_offset = 0, byte_length = 0;
  std::uint32_t byte_stride = 0;  ///< 0 = tight
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
  std::uint32_t buffer_view = kNone;  ///< kNone = zeros, which sparse entries then replace
  std::uint64_t byte_offset = 0, count = 0;
  ComponentType component_type = ComponentType::f32;
  ElementType type = ElementType::scalar;
  bool normalized = false;
  SparseAccessor sparse;
  std::vector<double> min, max;
};

struct MorphTarget {
  std::map<std::string, std::uint32_t> attributes;
};

struct Primitive {
  std::map<std::string, std::uint32_t> attributes;  ///< semantic -> accessor
  std::uint32_t indices = kNone, material = kNone;
  PrimitiveMode mode = PrimitiveMode::triangles;
  std::vector<MorphTarget> targets;
  Json extensions;
};

struct Mesh {
  std::string name;
  std::vector<Primitive> primitives;
  std::vector<double> weights;
  std::vector<std::string> target_names;  ///< extras.targetNames
};

struct Node {
  std::string name;
  std::vector<std::uint32_t> children;
  std::uint32_t mesh = kNone, skin = kNone, camera = kNone;
  bool has_matrix = false, has_trs = false;
  std::array<double, 16> matrix{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};  ///< column-major
  std::array<double, 3> translation{0, 0, 0}, scale{1, 1, 1};
  std::array<double, 4> rotation{0, 0, 0, 1};  ///< xyzw
  std::vector<double> weights;
  Json extensions;
};

struct Skin {
  std::string name;
  std::vector<std::uint32_t> joints;
  std::uint32_t inverse_bind_matrices = kNone, skeleton = kNone;
};

struct Camera {
  std::string name;
  bool perspective = true;
  double aspect = 0, yfov = 0, znear = 0, zfar = 0, xmag = 0, ymag = 0;  ///< 0 = absent
};

struct Scene {
  std::string name;
  std::vector<std::uint32_t> nodes;
};

struct Document {
  std::string generator, copyright, version, min_version;
  std::vector<std::string> extensions_used, extensions_required;
  std::vector<Buffer> buffers;
  std::vector<BufferView> buffer_views;
  std::vector<Accessor> accessors;
  std::vector<Mesh> meshes;
  std::vector<Node> nodes;
  std::vector<Skin> skins;
  std::vector<Animation> animations;
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::vector<Image> images;
  std::vector<TextureSampler> samplers;
  std::vector<Camera> cameras;
  std::vector<Scene> scenes;
  std::uint32_t scene = kNone;
  Json extensions;  ///< of the root object, for example KHR_lights_punctual

  /// Owns the memory that `Bytes` members point into, except the file itself: external files, data URIs, decoded views.
  /// A deque, because its entries stay where they are when it grows.
  std::deque<std::vector<std::byte>> storage;
};

}  // namespace sinew::gltf
