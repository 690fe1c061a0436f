// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "runtime/model/scene.h"
#include "runtime/model/vertex_visibility.h"
#include "viewer/upload/staging.h"

namespace sinew::viewer {

/// Vertex attributes in the order of their shader locations. `visibility` and `next_visibility` are ambient visibility
/// at the key poses before and after the time of the frame.
enum class Attribute : std::uint8_t {
  position,
  normal,
  tangent,
  texcoord_0,
  texcoord_1,
  color,
  visibility,
  next_visibility
};
inline constexpr std::size_t kAttributeCount = 8;
inline constexpr std::array<std::uint32_t, kAttributeCount> kAttributeBytes = {12, 12, 16, 8, 8, 16, 4, 4};

inline constexpr VkDeviceSize kAbsent = ~VkDeviceSize{0};

/// Byte offsets of the attributes and indices of a primitive; kAbsent = the primitive lacks the attribute. For ambient
/// visibility it is the offset of the first key pose; further poses follow it.
struct PrimitiveBuffers {
  std::array<VkDeviceSize, kAttributeCount> attributes{};
  VkDeviceSize indices = 0;
  std::uint32_t index_count = 0;
};

/// All meshes of a scene in one buffer. Attributes are separate streams, because deformation replaces only some of
/// them.
class MeshSet {
 public:
  /// in   visibility  null = none
  MeshSet(const Device& device, const Scene& scene, const VertexVisibility* visibility, Staging& staging);

  VkBuffer buffer() const noexcept { return buffer_.handle(); }
  const PrimitiveBuffers& primitive(std::uint32_t mesh, std::uint32_t primitive) const noexcept {
    return primitives_[first_[mesh] + primitive];
  }
  /// Offset of the default value of a missing attribute. Bind it with stride 0, so that every vertex reads it.
  VkDeviceSize default_of(Attribute attribute) const noexcept;

 private:
  Buffer buffer_;
  std::vector<PrimitiveBuffers> primitives_;
  std::vector<std::size_t> first_;  // [meshes] into primitives_
};

}  // namespace sinew::viewer
