// SPDX-License-Identifier: MIT
#include "viewer/upload/frame_upload.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <span>

#include "runtime/base/contract.h"
#include "viewer/upload/upload_materials.h"

namespace sinew::viewer {

struct FrameUpload::State {
  Device& device;
  const Scene& scene;
  std::vector<FrameVertices> slots;
  std::uint64_t uploaded_bytes = 0;
  UploadCounts counts;

  void upload_primitive(FrameVertices& slot, const Primitive& primitive, const DeformedPrimitive& deformed,
                        DeformedBuffers next, DeformedBuffers& last, bool kept);
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

/// Assigns buffer offsets to the deformed attributes of a primitive, starting at `at`, and advances `at`.
DeformedBuffers place(const DeformedPrimitive& deformed, VkDeviceSize& at) noexcept {
  const auto take = [&](const auto& values) {
    const VkDeviceSize begin = values.empty() ? kAbsent : at;
    at += room_for(values);
    return begin;
  };
  DeformedBuffers buffers;
  buffers.positions = take(deformed.positions);
  buffers.normals = take(deformed.normals);
  buffers.tangents = take(deformed.tangents);
  buffers.colors = take(deformed.colors);
  return buffers;
}

bool same_places(const DeformedBuffers& a, const DeformedBuffers& b) noexcept {
  return a.positions == b.positions && a.normals == b.normals && a.tangents == b.tangents && a.colors == b.colors;
}

/// Copies the attributes to their offsets. Returns the number of bytes.
std::uint64_t copy(const DeformedPrimitive& deformed, const DeformedBuffers& to, std::byte* memory) noexcept {
  std::uint64_t bytes = 0;
  const auto write = [&](const auto& values, VkDeviceSize at) {
    if (values.empty()) return;
    std::memcpy(memory + at, values.data(), values.size_bytes());
    bytes += values.size_bytes();
  };
  write(deformed.positions, to.positions);
  write(deformed.normals, to.normals);
  write(deformed.tangents, to.tangents);
  write(deformed.colors, to.colors);
  return bytes;
}

glm::vec3 centre_of(const Primitive& primitive, const DeformedPrimitive& deformed) noexcept {
  if (deformed.positions.empty())
    return primitive.bounds.empty() ? glm::vec3(0.0f) : 0.5f * (primitive.bounds.lower + primitive.bounds.upper);
  Aabb box;
  for (const glm::vec3& p : deformed.positions) box.add(p);
  return box.empty() ? glm::vec3(0.0f) : 0.5f * (box.lower + box.upper);
}

bool is_sorted(const Scene& scene, const Primitive& primitive) noexcept {
  const auto is = [&](std::uint32_t material) { return material != kNone && shows_behind(scene.materials[material]); };
  const auto& variants = primitive.variant_materials;
  return is(primitive.material) ||
         std::any_of(variants.begin(), variants.end(), [&](const VariantMaterial& v) { return is(v.material); });
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
    : state_(new State{device, scene, std::vector<FrameVertices>(slot_count), 0, {}}) {
  for (FrameVertices& slot : state_->slots) slot.look = SceneLook(scene);
}

FrameUpload::~FrameUpload() = default;

/// Uploads one primitive to the slot, unless the slot already holds its vertices.
void FrameUpload::State::upload_primitive(FrameVertices& slot, const Primitive& primitive,
                                          const DeformedPrimitive& deformed, DeformedBuffers next,
                                          DeformedBuffers& last, bool kept) {
  const bool unchanged =
      kept && deformed.since_frame != 0 && last.frame >= deformed.since_frame && same_places(next, last);
  if (unchanged) {
    next.centre = last.centre;
    ++counts.unchanged;
  } else {
    const std::uint64_t bytes = copy(deformed, next, slot.buffer.mapped());
    counts.bytes += bytes;
    counts.written += bytes > 0;
    if (is_sorted(scene, primitive)) next.centre = centre_of(primitive, deformed);
  }
  last = next;
}

void FrameUpload::update(std::uint32_t slot_index, const FrameResult& result, std::uint64_t source) {
  FrameVertices& slot = state_->slots[slot_index];
  state_->counts = {};
  const bool follows = slot.filled && slot.source == source;
  if (follows && slot.frame == result.frame) return;
  const auto start = std::chrono::steady_clock::now();
  const Scene& scene = state_->scene;
  CONTRACT(result.instances.size() == scene.instances.size());
  const VkDeviceSize needed = bytes_of(result);
  const bool kept = follows && slot.buffer.size() >= needed;
  if (needed > 0 && slot.buffer.size() < needed)
    slot.buffer = Buffer(state_->device, needed, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT, MemoryUse::upload);
  slot.instances.resize(result.instances.size());
  slot.primitives.resize(result.primitives.size());
  VkDeviceSize at = 0;
  for (std::size_t i = 0; i < result.instances.size(); ++i) {
    const InstanceResult& instance = result.instances[i];
    const bool hidden = !result.hidden.empty() && result.hidden[scene.instances[i].joint];
    slot.instances[i] = {instance.world_from_mesh, instance.mirrored,       instance.visible, hidden,
                         instance.bounds,          instance.first_primitive};
    const Mesh& mesh = scene.meshes[scene.instances[i].mesh];
    for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
      const DeformedPrimitive& deformed = result.primitives[instance.first_primitive + p];
      DeformedBuffers next = place(deformed, at);
      next.frame = result.frame;
      next.since = deformed.since_frame;
      state_->upload_primitive(slot, mesh.primitives[p], deformed, next, slot.primitives[instance.first_primitive + p],
                               kept);
    }
  }
  place_lights(scene, result, slot);
  apply_properties(scene, result.properties, slot.look);
  state_->uploaded_bytes += state_->counts.bytes;
  slot.frame = result.frame;
  slot.source = source;
  slot.filled = true;
  state_->counts.time_us = std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
}

const UploadCounts& FrameUpload::last_update() const noexcept { return state_->counts; }

std::uint64_t FrameUpload::uploaded_bytes() const noexcept { return state_->uploaded_bytes; }

const SceneLook& FrameUpload::look(std::uint32_t slot) const noexcept { return state_->slots[slot].look; }

const FrameVertices& FrameUpload::vertices(std::uint32_t slot) const noexcept { return state_->slots[slot]; }

}  // namespace sinew::viewer
