// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "runtime/model/scene.h"
#include "runtime/model/vertex_access.h"
#include "viewer/upload/staging.h"

namespace sinew::viewer {

/// Vertex attributes in the order of their shader locations.
/// `access` and `next_access` are ambient access in the two key poses around the time of the frame.
enum class Attribute : std::uint8_t { position, normal, tangent, texcoord_0, texcoord_1, color, access, next_access };
inline constexpr std::size_t kAttributeCount = 8;
inline constexpr std::array<std::uint32_t, kAttributeCount> kAttributeBytes = {12, 12, 16, 8, 8, 16, 4, 4};

inline constexpr VkDeviceSize kAbsent = ~VkDeviceSize{0};

/// Byte offsets of the attributes and indices of a primitive; kAbsent = the primitive lacks the attribute. Those of
/// ambient access are of the first key pose; the others follow it.
struct PrimitiveBuffers {
  std::array<VkDeviceSize, kAttributeCount> attributes{};
  VkDeviceSize indices = 0;
  std::uint32_t index_count = 0;
};

/// All meshes of a scene in one buffer. Each attribute is a stream of its own, because deformation replaces only some.
class MeshSet {
 public:
  /// in   access  null = none
  MeshSet(const Device& device, const Scene& scene, const VertexAccess* access, Staging& staging);

  VkBuffer buffer() const noexcept { return buffer_.handle(); }
  const PrimitiveBuffers& primitive(std::uint32_t mesh, std::uint32_t primitive) const noexcept {
    return primitives_[first_[mesh] + primitive];
  }
  /// Offset of the default value of an absent attribute. It is bound with stride 0, so that every vertex reads it.
  VkDeviceSize default_of(Attribute attribute) const noexcept;

 private:
  Buffer buffer_;
  std::vector<PrimitiveBuffers> primitives_;
  std::vector<std::size_t> first_;  // [meshes] into primitives_
};

}  // namespace sinew::viewer
