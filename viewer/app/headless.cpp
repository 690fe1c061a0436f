// SPDX-License-Identifier: MIT
#include "viewer/app/headless.h"

#include <cstring>

#include "viewer/device/buffer.h"
#include "viewer/device/image.h"

namespace sinew::viewer {

namespace {

constexpr VkFormat kFormat = VK_FORMAT_R8G8B8A8_UNORM;

}  // namespace

struct Headless::State {
  State(Device& used, const Scene& scene, VkExtent2D size, const OcclusionShape& occlusion,
        const VertexVisibility* visibility, const TextureFilter& filter)
      : device(used),
        extent(size),
        scene_upload(used, scene, 1, visibility, filter),
        frame_upload(used, scene, 1),
        renderer(used, kFormat, 1, occlusion),
        image(used, {kFormat, size, 1, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT}),
        pixels(used, VkDeviceSize{4} * size.width * size.height, VK_BUFFER_USAGE_TRANSFER_DST_BIT,
               MemoryUse::read_back) {}

  Device& device;
  VkExtent2D extent;
  SceneUpload scene_upload;
  FrameUpload frame_upload;
  FrameRenderer renderer;
  GpuImage image;
  Buffer pixels;
  std::uint64_t pictures = 0;
};

Headless::Headless(Device& device, const Scene& scene, std::uint32_t width, std::uint32_t height,
                   const OcclusionShape& occlusion, const VertexVisibility* visibility, const TextureFilter& filter)
    : state_(std::make_unique<State>(device, scene, VkExtent2D{width, height}, occlusion, visibility, filter)) {}

Headless::~Headless() = default;

Picture Headless::render(const FrameResult& frame, const View& view, const RenderOptions& options,
                         std::span<const LineVertex> lines, std::uint32_t variant, const VisibilityBlend& visibility,
                         std::uint64_t source) {
  State& s = *state_;
  // A call without a source counts as a new one, because consecutive frames may come from different frame buffers.
  constexpr std::uint64_t kGiven = std::uint64_t{1} << 63;
  s.frame_upload.update(0, frame, source != 0 ? kGiven + source : ++s.pictures);
  s.scene_upload.update(0, s.frame_upload.look(0));
  const DrawnScene drawn{&s.scene_upload, &s.frame_upload, variant, visibility};
  FrameInputs inputs;
  inputs.scenes = {&drawn, 1};
  inputs.view = view;
  inputs.options = options;
  inputs.lines = lines;
  s.device.run_now([&](VkCommandBuffer commands) {
    s.renderer.record(commands, {s.image.handle(), s.image.view(), s.extent, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL},
                      inputs);
    read_back(commands, s.image.handle(), s.extent, s.pixels.handle());
  });
  Picture picture{s.extent.width, s.extent.height, {}};
  picture.rgba.resize(s.pixels.size());
  std::memcpy(picture.rgba.data(), s.pixels.mapped(), picture.rgba.size());
  return picture;
}

std::span<const PassTime> Headless::pass_times() const { return state_->renderer.pass_times(0); }
const FrameReport& Headless::report() const { return state_->renderer.report(0); }
const UploadCounts& Headless::upload_counts() const { return state_->frame_upload.last_update(); }
std::uint64_t Headless::texel_bytes() const { return state_->scene_upload.materials().texel_bytes(); }

}  // namespace sinew::viewer
