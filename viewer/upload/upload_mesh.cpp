// SPDX-License-Identifier: MIT
#include "viewer/upload/upload_mesh.h"

namespace sinew::viewer {

namespace {

/// Appends a stream at the next multiple of 16 bytes and returns its offset.
template <class T>
VkDeviceSize append(std::vector<std::byte>& bytes, const std::vector<T>& values) {
  if (values.empty()) return kAbsent;
  bytes.resize((bytes.size() + 15) / 16 * 16);
  const VkDeviceSize at = bytes.size();
  const auto source = std::as_bytes(std::span(values));
  bytes.insert(bytes.end(), source.begin(), source.end());
  return at;
}

constexpr VkDeviceSize kZeros = 0, kOnes = 16, kUnitX = 32;

}  // namespace

MeshSet::MeshSet(const Device& device, const Scene& scene, const VertexVisibility* visibility, Staging& staging) {
  std::vector<std::byte> bytes;
  append(bytes, std::vector<glm::vec4>{glm::vec4(0.0f), glm::vec4(1.0f), {1.0f, 0.0f, 0.0f, 1.0f}});  // the defaults
  for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
    first_.push_back(primitives_.size());
    for (std::size_t p = 0; p < scene.meshes[m].primitives.size(); ++p) {
      const Primitive& primitive = scene.meshes[m].primitives[p];
      PrimitiveBuffers buffers;
      const auto texcoords = [&](std::size_t set) {
        return primitive.texcoords.size() > set ? append(bytes, primitive.texcoords[set]) : kAbsent;
      };
      buffers.attributes = {append(bytes, primitive.positions),
                            append(bytes, primitive.normals),
                            append(bytes, primitive.tangents),
                            texcoords(0),
                            texcoords(1),
                            append(bytes, primitive.colors),
                            visibility ? append(bytes, visibility->values[m][p]) : kAbsent,
                            kAbsent};
      buffers.attributes.back() = buffers.attributes[static_cast<std::size_t>(Attribute::visibility)];
      buffers.indices = append(bytes, primitive.indices);
      buffers.index_count = static_cast<std::uint32_t>(primitive.indices.size());
      primitives_.push_back(buffers);
    }
  }
  buffer_ =
      Buffer(device, bytes.size(),
             VK_BUFFER_USAGE_VERTEX_BUFFER_BIT | VK_BUFFER_USAGE_INDEX_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
             MemoryUse::device);
  staging.copy(buffer_, bytes);
}

VkDeviceSize MeshSet::default_of(Attribute attribute) const noexcept {
  if (attribute == Attribute::color || attribute >= Attribute::visibility) return kOnes;
  return attribute == Attribute::tangent ? kUnitX : kZeros;
}

}  // namespace sinew::viewer
