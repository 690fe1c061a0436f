// SPDX-License-Identifier: MIT
#include "tests/viewer/float_picture.h"

#include <cmath>
#include <cstddef>
#include <cstring>
#include <span>

#include <glm/geometric.hpp>

#include "viewer/device/buffer.h"
#include "viewer/device/image.h"

namespace sinew::viewer {

namespace {

struct TestDevice {
  std::unique_ptr<Device> device;
  std::string reason;

  TestDevice() {
    try {
      device = std::make_unique<Device>(DeviceOptions{.validation = true});
    } catch (const DeviceError& error) {
      reason = error.what();
    }
  }
};

TestDevice& only() {
  static TestDevice device;
  return device;
}

/// Draws one frame into an image of this format and reads its pixels.
void render_pixels(const BuiltScene& built, DrawnScene drawn, VkExtent2D extent, VkFormat format,
                   const OcclusionShape& occlusion, FrameInputs inputs, std::span<std::byte> pixels) {
  Device& device = *test_device();
  FrameUpload frame(device, built.scene, 1);
  frame.update(0, built.frame());
  drawn.frame = &frame;
  inputs.scenes = {&drawn, 1};
  FrameRenderer renderer(device, format, 1, occlusion);
  const GpuImage image(device,
                       {format, extent, 1, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT});
  const Buffer read(device, pixels.size(), VK_BUFFER_USAGE_TRANSFER_DST_BIT, MemoryUse::read_back);
  device.run_now([&](VkCommandBuffer commands) {
    renderer.record(commands, {image.handle(), image.view(), extent, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL}, inputs);
    read_back(commands, image.handle(), extent, read.handle());
  });
  std::memcpy(pixels.data(), read.mapped(), pixels.size());
}

}  // namespace

Device* test_device() { return only().device.get(); }
const std::string& no_device_reason() { return only().reason; }

FloatPicture render_float(const BuiltScene& built, int width, int height, const View& view,
                          const RenderOptions& options, const FrameInputs& extras, const OcclusionShape& occlusion,
                          const VertexVisibility* visibility, const VisibilityBlend& blend,
                          const TextureFilter& filter) {
  const VkExtent2D extent{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
  const SceneUpload scene(*test_device(), built.scene, 1, visibility, filter);
  FrameInputs inputs = extras;
  inputs.view = view;
  inputs.options = options;
  FloatPicture picture{width, height, std::vector<glm::vec4>(extent.width * extent.height)};
  render_pixels(built, {&scene, nullptr, kNone, blend}, extent, VK_FORMAT_R32G32B32A32_SFLOAT, occlusion, inputs,
                std::as_writable_bytes(std::span(picture.pixels)));
  return picture;
}

std::vector<std::uint8_t> render_bytes(const BuiltScene& built, int width, int height, const View& view,
                                       const RenderOptions& options, VkFormat format) {
  const VkExtent2D extent{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
  const SceneUpload scene(*test_device(), built.scene, 1);
  FrameInputs inputs;
  inputs.view = view;
  inputs.options = options;
  std::vector<std::uint8_t> bytes(std::size_t{4} * extent.width * extent.height);
  render_pixels(built, {&scene}, extent, format, {}, inputs, std::as_writable_bytes(std::span(bytes)));
  return bytes;
}

reference::DepthAndNormals empty_image(int width, int height, const View& view) {
  reference::DepthAndNormals image;
  image.width = width;
  image.height = height;
  image.cot_y = 1.0 / std::tan(0.5 * view.fov_y_rad);
  image.cot_x = image.cot_y * height / width;
  image.near_m = view.near_m;
  return image;
}

reference::DepthAndNormals gpu_depth_and_normals(const BuiltScene& built, int width, int height, const View& view,
                                                 RenderOptions options) {
  options.transparent_background = true;  // alpha is 0 where nothing was drawn
  options.depth_range = {0.0f, 64.0f};
  options.show = Show::depth;
  const FloatPicture depth = render_float(built, width, height, view, options);
  options.show = Show::normals;
  const FloatPicture normals = render_float(built, width, height, view, options);
  reference::DepthAndNormals image = empty_image(width, height, view);
  for (std::size_t i = 0; i < depth.pixels.size(); ++i) {
    const bool drawn = depth.pixels[i].a > 0.0f;
    const glm::dvec3 n = glm::dvec3(normals.pixels[i]) * 2.0 - 1.0;
    image.distance.push_back(drawn ? (1.0 - static_cast<double>(depth.pixels[i].r)) * 64.0 : 0.0);
    image.normals.push_back(drawn && glm::length(n) > 0.5 ? glm::normalize(n) : glm::dvec3(0.0));
  }
  return image;
}

}  // namespace sinew::viewer
