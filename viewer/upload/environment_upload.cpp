// SPDX-License-Identifier: MIT
#include "viewer/upload/environment_upload.h"

#include <cstring>
#include <span>

#include <glm/common.hpp>
#include <glm/gtc/packing.hpp>
#include <glm/packing.hpp>

#include "viewer/light/split_sum.h"
#include "viewer/upload/staging.h"

namespace sinew::viewer {
namespace {

constexpr float kLargestHalf = 65504.0f;  // the largest half float

template <class Packed>
void append(std::vector<std::uint8_t>& bytes, const Packed& packed) {
  const std::size_t at = bytes.size();
  bytes.resize(at + sizeof(packed));
  std::memcpy(bytes.data() + at, &packed, sizeof(packed));
}

MipLevel as_half_floats(const CubeMap& cube) {
  MipLevel level{cube.size, cube.size, {}};
  for (const glm::vec3& texel : cube.texels)
    append(level.rgba, glm::packHalf4x16(glm::vec4(glm::clamp(texel, 0.0f, kLargestHalf), 1.0f)));
  return level;
}

std::vector<MipLevel> levels_of(const Environment& environment) {
  std::vector<MipLevel> levels;
  for (const CubeMap& cube : environment.reflected) levels.push_back(as_half_floats(cube));
  return levels;
}

GpuImage upload(const Device& device, VkFormat format, bool cube, std::span<const MipLevel> levels) {
  GpuImage image(device, {format,
                          {levels[0].width, levels[0].height},
                          static_cast<std::uint32_t>(levels.size()),
                          VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                          cube});
  Staging staging(device);
  staging.copy(image, levels);
  staging.send();
  return image;
}

GpuImage upload_cube(const Device& device, std::span<const MipLevel> levels) {
  return upload(device, VK_FORMAT_R16G16B16A16_SFLOAT, true, levels);
}

GpuImage upload_table(const Device& device, std::uint32_t size, std::span<const glm::vec3> values) {
  MipLevel level{size, size, {}};
  for (const glm::vec3& value : values) append(level.rgba, glm::packHalf4x16(glm::vec4(value, 0.0f)));
  return upload(device, VK_FORMAT_R16G16B16A16_SFLOAT, false, {&level, 1});
}

}  // namespace

EnvironmentUpload::EnvironmentUpload(Device& device) : device_(device) {
  VkSamplerCreateInfo linear{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
  linear.magFilter = linear.minFilter = VK_FILTER_LINEAR;
  linear.mipmapMode = VK_SAMPLER_MIPMAP_MODE_LINEAR;
  linear.addressModeU = linear.addressModeV = linear.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  linear.maxLod = VK_LOD_CLAMP_NONE;
  must(vkCreateSampler(device.handle(), &linear, nullptr, &sampler_), "vkCreateSampler");
  const MipLevel black = as_half_floats({1, std::vector<glm::vec3>(kCubeFaces, glm::vec3(0.0f))});
  cube_ = upload_cube(device, {&black, 1});
  const glm::vec3 nothing(0.0f);
  table_ = upload_table(device, 1, {&nothing, 1});
}

EnvironmentUpload::~EnvironmentUpload() { vkDestroySampler(device_.handle(), sampler_, nullptr); }

void EnvironmentUpload::show(const std::shared_ptr<const Environment>& environment) {
  if (environment == shown_) return;
  vkDeviceWaitIdle(device_.handle());  // frames in flight may read the images
  if (!has_table_ && !environment->split_sum.empty()) {
    table_ = upload_table(device_, kSplitSumSize, environment->split_sum);
    has_table_ = true;
  }
  show_table();
  cube_ = upload_cube(device_, levels_of(*environment));
  shown_ = environment;
}

void EnvironmentUpload::show_table() {
  if (has_table_) return;
  vkDeviceWaitIdle(device_.handle());
  table_ = upload_table(device_, kSplitSumSize, split_sum_table());
  has_table_ = true;
}

VkDescriptorImageInfo EnvironmentUpload::environment() const noexcept {
  return {sampler_, cube_.view(), VK_IMAGE_LAYOUT_READ_ONLY_OPTIMAL};
}

VkDescriptorImageInfo EnvironmentUpload::split_sum() const noexcept {
  return {sampler_, table_.view(), VK_IMAGE_LAYOUT_READ_ONLY_OPTIMAL};
}

}  // namespace sinew::viewer
