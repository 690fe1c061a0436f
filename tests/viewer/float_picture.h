// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "tests/reference/ssao.h"
#include "tests/viewer/built_scenes.h"
#include "viewer/passes/frame_renderer.h"

namespace sinew::viewer {

/// The device for tests, created once, with validation if it is installed. Null and a reason if there is none.
Device* test_device();
const std::string& no_device_reason();

/// Output of the last pass, in float instead of 8 bits.
struct FloatPicture {
  int width = 0, height = 0;
  std::vector<glm::vec4> pixels;

  const glm::vec4& at(int x, int y) const { return pixels[static_cast<std::size_t>(y * width + x)]; }
};

FloatPicture render_float(const BuiltScene& built, int width, int height, const View& view,
                          const RenderOptions& options, const FrameInputs& extras = {},
                          const OcclusionShape& occlusion = {}, const VertexVisibility* visibility = nullptr,
                          const VisibilityBlend& blend = {}, const TextureFilter& filter = {});

/// The bytes of a picture in an 8-bit format.
std::vector<std::uint8_t> render_bytes(const BuiltScene& built, int width, int height, const View& view,
                                       const RenderOptions& options, VkFormat format);

/// Distances and normals as the GPU drew them, read from the pictures of Show::depth and Show::normals.
reference::DepthAndNormals gpu_depth_and_normals(const BuiltScene& built, int width, int height, const View& view,
                                                 RenderOptions options);

/// An image without surfaces, with the same camera, for the reference.
reference::DepthAndNormals empty_image(int width, int height, const View& view);

}  // namespace sinew::viewer
