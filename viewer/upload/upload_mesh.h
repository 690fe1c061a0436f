// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "runtime/model/scene.h"
#include "viewer/upload/staging.h"

namespace sinew::viewer {

/// Vertex attributes in the order of their shader locations.
enum class Attribute : std::uint8_t { position, normal, tangent, texcoord_0, texcoord_1, color };
inline constexpr std::size_t kAttributeCount = 6;
inline constexpr std::array<std::uint32_t, kAttributeCount> kAttributeBytes = {12, 12, 16, 8, 8, 16};

inline constexpr VkDeviceSize kAbsent = ~VkDeviceSize{0};

/// Where the attributes and indices of a primitive lie, in bytes; kAbsent = it has none.
struct PrimitiveBuffers {
  std::array<VkDeviceSize, kAttributeCount> attributes{};
  VkDeviceSize indices = 0;
  std::uint32_t index_count = 0;
};

/// All meshes of a scene in one buffer. Attributes are separate streams, because deformation replaces some and not
/// others.
class MeshSet {
 public:
  MeshSet(const Device& device, const Scene& scene, Staging& staging);

  VkBuffer buffer() const noexcept { return buffer_.handle(); }
  const PrimitiveBuffers& primitive(std::uint32_t mesh, std::uint32_t primitive) const noexcept {
    return primitives_[first_[mesh] + primitive];
  }
  /// Bound with stride 0 for an absent attribute: every vertex reads the same default.
  VkDeviceSize default_of(Attribute attribute) const noexcept;

 private:
  Buffer buffer_;
  std::vector<PrimitiveBuffers> primitives_;
  std::vector<std::size_t> first_;  // [meshes] into primitives_
};

}  // namespace sinew::viewer
