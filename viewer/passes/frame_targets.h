// SPDX-License-Identifier: MIT
#pragma once
#include <array>

#include "viewer/device/image.h"
#include "viewer/passes/frame_graph.h"

namespace sinew::viewer {

/// Intermediate images of a frame.
enum class Target : std::uint8_t {
  depth,
  normals,
  ao,
  half_blurred_ao,
  color,
  shadow,
  color_samples,
  depth_samples,
  unlit,
  unlit_samples,
  light_sums,  ///< block sums of log luminance, for automatic exposure
  exposure,
  behind,  ///< colour and coverage of the opaque picture, with mip levels
  behind_unlit,
  weighted_sums,  ///< sum of colour * coverage * weight of blended surfaces; alpha: sum of coverage * weight
  weighted_coverage,
  weighted_unlit,  ///< same sum, for unlit surfaces only
  weighted_sums_samples,
  weighted_coverage_samples,
  weighted_unlit_samples
};
inline constexpr std::size_t kTargetCount = 20;

inline constexpr std::uint32_t kSmoothSamples = 4;  ///< samples per pixel of the multisampled targets

inline constexpr std::uint32_t kExposureBlocks = 32;  ///< width and height of light_sums

inline constexpr VkFormat kDepthFormat = VK_FORMAT_D32_SFLOAT;
inline constexpr VkFormat kNormalFormat = VK_FORMAT_R16G16B16A16_SFLOAT;
/// Ambient visibility, distance and packed normal, so that one fetch reads all about a neighbour.
inline constexpr VkFormat kAoFormat = VK_FORMAT_R32G32B32A32_SFLOAT;
inline constexpr VkFormat kExposureFormat = VK_FORMAT_R32G32B32A32_SFLOAT;
inline constexpr VkFormat kColorFormat = VK_FORMAT_R16G16B16A16_SFLOAT;

/// Image uses of the passes.
inline constexpr ImageUse kWriteColor{VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                                      VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT,
                                      VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
inline constexpr ImageUse kWriteDepth{
    VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT,
    VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT,
    VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL};
inline constexpr ImageUse kReadDepth{
    VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT |
        VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT,
    VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT | VK_ACCESS_2_SHADER_SAMPLED_READ_BIT,
    VK_IMAGE_LAYOUT_READ_ONLY_OPTIMAL};
inline constexpr ImageUse kCopyFrom{VK_PIPELINE_STAGE_2_BLIT_BIT, VK_ACCESS_2_TRANSFER_READ_BIT,
                                    VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL};
inline constexpr ImageUse kCopyTo{VK_PIPELINE_STAGE_2_BLIT_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                                  VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};
inline constexpr ImageUse kReadInShader{VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT,
                                        VK_IMAGE_LAYOUT_READ_ONLY_OPTIMAL};

/// Owns the images that a frame graph needs, and tracks the last use of each for barriers.
class FrameTargets {
 public:
  /// in   ao_step  OcclusionShape::step
  FrameTargets(const Device& device, std::uint32_t ao_step);

  /// Creates and destroys images to match the graph and extent. Waits for the device if anything changes.
  void fit(const FrameGraph& graph, VkExtent2D extent);

  /// Inserts the barrier between the last use of an image and the next one.
  /// in   keep  false = the contents are discarded
  void next_use(VkCommandBuffer commands, Target target, const ImageUse& use, bool keep = true);

  /// Copies an image into mip level 0 of another image of the same size, and downsamples each level into the next. Old
  /// contents are discarded.
  void copy_into_levels(VkCommandBuffer commands, Target from, Target to);

  bool exists(Target target) const noexcept { return static_cast<bool>(slot(target).image); }
  /// View of the image, or of a single black texel if the image does not exist.
  VkImageView view(Target target) const noexcept {
    return exists(target) ? slot(target).image.view() : nothing_.view();
  }
  VkImageView nothing() const noexcept { return nothing_.view(); }
  VkExtent2D extent() const noexcept { return extent_; }
  /// Pixels per texel of Target::ao and half_blurred_ao, along each axis.
  std::uint32_t ao_step() const noexcept { return step_; }
  /// Extent of Target::ao and half_blurred_ao: that of the picture divided by the step, rounded up.
  VkExtent2D ao_extent() const noexcept {
    return {(extent_.width + step_ - 1) / step_, (extent_.height + step_ - 1) / step_};
  }

 private:
  struct Slot {
    GpuImage image;
    ImageUse last;
  };
  Slot& slot(Target target) noexcept { return slots_[static_cast<std::size_t>(target)]; }
  const Slot& slot(Target target) const noexcept { return slots_[static_cast<std::size_t>(target)]; }

  const Device& device_;
  std::uint32_t step_;
  std::array<Slot, kTargetCount> slots_;
  GpuImage nothing_;
  VkExtent2D extent_{};
  std::uint32_t shadow_maps_ = 0;
};

}  // namespace sinew::viewer
