// SPDX-License-Identifier: MIT
#include "viewer/upload/frame_upload.h"

#include <algorithm>
#include <cstring>
#include <span>

#include "runtime/base/contract.h"
#include "viewer/upload/frame_vertices.h"

namespace sinew::viewer {

struct FrameUpload::State {
  Device& device;
  const Scene& scene;
  std::vector<FrameVertices> slots;
  std::uint64_t uploaded_bytes = 0;
};

namespace {

template <class T>
VkDeviceSize room_for(std::span<const T> values) noexcept {
  return (values.size_bytes() + 15) / 16 * 16;
}

VkDeviceSize bytes_of(const FrameResult& result) noexcept {
  VkDeviceSize bytes = 0;
  for (const DeformedPrimitive& p : result.primitives)
    bytes += room_for(p.positions) + room_for(p.normals) + room_for(p.tangents) + room_for(p.colors);
  return bytes;
}

/// Fills a slot's buffer front to back.
struct Writer {
  std::byte* memory;
  VkDeviceSize at = 0;
  std::uint64_t written = 0;

  template <class T>
  VkDeviceSize write(std::span<const T> values) noexcept {
    if (values.empty()) return kAbsent;
    const VkDeviceSize begin = at;
    std::memcpy(memory + begin, values.data(), values.size_bytes());
    at += room_for(values);
    written += values.size_bytes();
    return begin;
  }
};

glm::vec3 centre_of(const Primitive& primitive, const DeformedPrimitive& deformed) noexcept {
  if (deformed.positions.empty())
    return primitive.bounds.empty() ? glm::vec3(0.0f) : 0.5f * (primitive.bounds.lower + primitive.bounds.upper);
  Aabb box;
  for (const glm::vec3& p : deformed.positions) box.add(p);
  return box.empty() ? glm::vec3(0.0f) : 0.5f * (box.lower + box.upper);
}

bool blended(const Scene& scene, const Primitive& primitive) noexcept {
  const auto blends = [&](std::uint32_t material) {
    return material != kNone && scene.materials[material].alpha_mode == AlphaMode::blend;
  };
  const auto& variants = primitive.variant_materials;
  return blends(primitive.material) ||
         std::any_of(variants.begin(), variants.end(), [&](const VariantMaterial& v) { return blends(v.material); });
}

void place_lights(const Scene& scene, const FrameResult& result, FrameVertices& slot) {
  slot.world_from_light.resize(scene.lights.size());
  slot.light_shines.resize(scene.lights.size());
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const std::uint32_t joint = scene.lights[i].joint;
    const bool placed = joint < result.model.size();
    slot.world_from_light[i] = placed ? result.model[joint] : Affine{};
    slot.light_shines[i] = joint != kNone && (result.hidden.empty() || !result.hidden[joint]);
  }
}

}  // namespace

FrameUpload::FrameUpload(Device& device, const Scene& scene, std::uint32_t slot_count)
    : state_(new State{device, scene, std::vector<FrameVertices>(slot_count), 0}) {
  for (FrameVertices& slot : state_->slots) slot.look = SceneLook(scene);
}

FrameUpload::~FrameUpload() = default;

void FrameUpload::update(std::uint32_t slot_index, const FrameResult& result, std::uint64_t source) {
  FrameVertices& slot = state_->slots[slot_index];
  if (slot.filled && slot.frame == result.frame && slot.source == source) return;
  const Scene& scene = state_->scene;
  CONTRACT(result.instances.size() == scene.instances.size());
  const VkDeviceSize needed = bytes_of(result);
  if (needed > 0 && slot.buffer.size() < needed)
    slot.buffer = Buffer(state_->device, needed, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT, MemoryUse::upload);
  Writer writer{slot.buffer.mapped()};
  slot.instances.resize(result.instances.size());
  slot.primitives.resize(result.primitives.size());
  for (std::size_t i = 0; i < result.instances.size(); ++i) {
    const InstanceResult& instance = result.instances[i];
    slot.instances[i] = {instance.world_from_mesh, instance.mirrored, instance.visible, instance.first_primitive};
    const Mesh& mesh = scene.meshes[scene.instances[i].mesh];
    for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
      const DeformedPrimitive& deformed = result.primitives[instance.first_primitive + p];
      DeformedBuffers& buffers = slot.primitives[instance.first_primitive + p];
      buffers.positions = writer.write(deformed.positions);
      buffers.normals = writer.write(deformed.normals);
      buffers.tangents = writer.write(deformed.tangents);
      buffers.colors = writer.write(deformed.colors);
      if (blended(scene, mesh.primitives[p])) buffers.centre = centre_of(mesh.primitives[p], deformed);
    }
  }
  place_lights(scene, result, slot);
  apply_properties(scene, result.properties, slot.look);
  state_->uploaded_bytes += writer.written;
  slot.frame = result.frame, slot.source = source, slot.filled = true;
}

std::uint64_t FrameUpload::uploaded_bytes() const noexcept { return state_->uploaded_bytes; }

const SceneLook& FrameUpload::look(std::uint32_t slot) const noexcept { return state_->slots[slot].look; }

const FrameVertices& FrameUpload::vertices(std::uint32_t slot) const noexcept { return state_->slots[slot]; }

}  // namespace sinew::viewer
