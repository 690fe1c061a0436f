// SPDX-License-Identifier: MIT
#include "viewer/upload/staging.h"

#include <cstring>

namespace sinew::viewer {

namespace {

constexpr VkDeviceSize kSendAbove = VkDeviceSize{64} << 20;

}  // namespace

void Staging::copy(const Buffer& to, std::span<const std::byte> bytes) {
  if (bytes.empty()) return;
  Buffer from(device_, bytes.size(), VK_BUFFER_USAGE_TRANSFER_SRC_BIT, MemoryUse::upload);
  std::memcpy(from.mapped(), bytes.data(), bytes.size());
  buffers_.push_back(std::move(from));
  copies_.push_back({buffers_.size() - 1, to.handle(), bytes.size()});
  pending_ += bytes.size();
  if (pending_ > kSendAbove) send();
}

void Staging::copy(const GpuImage& to, std::span<const MipLevel> levels) {
  VkDeviceSize bytes = 0;
  for (const MipLevel& level : levels) bytes += level.rgba.size();
  Buffer from(device_, bytes, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, MemoryUse::upload);
  ImageCopy copy{buffers_.size(), to.handle(), {}};
  VkDeviceSize at = 0;
  for (std::uint32_t mip = 0; mip < levels.size(); ++mip) {
    std::memcpy(from.mapped() + at, levels[mip].rgba.data(), levels[mip].rgba.size());
    VkBufferImageCopy region{};
    region.bufferOffset = at;
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, mip, 0, to.shape().layers()};
    region.imageExtent = {levels[mip].width, levels[mip].height, 1};
    copy.regions.push_back(region);
    at += levels[mip].rgba.size();
  }
  buffers_.push_back(std::move(from));
  images_.push_back(std::move(copy));
  pending_ += bytes;
  if (pending_ > kSendAbove) send();
}

void Staging::send() {
  if (buffers_.empty()) return;
  constexpr ImageUse fresh{};
  constexpr ImageUse written{VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                             VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};
  constexpr ImageUse read{VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT,
                          VK_IMAGE_LAYOUT_READ_ONLY_OPTIMAL};
  device_.run_now([&](VkCommandBuffer commands) {
    for (const BufferCopy& copy : copies_) {
      const VkBufferCopy region{0, 0, copy.bytes};
      vkCmdCopyBuffer(commands, buffers_[copy.staged].handle(), copy.buffer, 1, &region);
    }
    for (const ImageCopy& copy : images_) {
      barrier(commands, copy.image, VK_IMAGE_ASPECT_COLOR_BIT, fresh, written);
      vkCmdCopyBufferToImage(commands, buffers_[copy.staged].handle(), copy.image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                             static_cast<std::uint32_t>(copy.regions.size()), copy.regions.data());
      barrier(commands, copy.image, VK_IMAGE_ASPECT_COLOR_BIT, written, read);
    }
  });  // run_now waits for the queue, which makes the copies visible to later submits
  buffers_.clear();
  images_.clear();
  copies_.clear();
  pending_ = 0;
}

}  // namespace sinew::viewer
