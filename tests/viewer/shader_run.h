// SPDX-License-Identifier: MIT
#pragma once
#include <cstring>
#include <span>
#include <type_traits>

#include "viewer/device/buffer.h"

namespace sinew::viewer {

/// A compute shader with two storage buffers: binding 0 is read, binding 1 is written. One invocation at a time.
class ShaderRun {
 public:
  ShaderRun(Device& device, std::span<const std::uint32_t> code, VkDeviceSize given_bytes, VkDeviceSize answer_bytes);
  ~ShaderRun();
  ShaderRun(const ShaderRun&) = delete;
  ShaderRun& operator=(const ShaderRun&) = delete;

  template <class Answer, class Given>
  Answer answer_to(const Given& given) {
    static_assert(std::is_trivially_copyable_v<Answer> && std::is_trivially_copyable_v<Given>);
    std::memcpy(given_.mapped(), &given, sizeof(given));
    run();
    Answer answer;
    std::memcpy(&answer, answer_.mapped(), sizeof(answer));
    return answer;
  }

 private:
  void make_set();
  void make_pipeline(std::span<const std::uint32_t> code);
  void run();

  Device& device_;
  Buffer given_, answer_;
  VkDescriptorSetLayout set_layout_ = VK_NULL_HANDLE;
  VkDescriptorPool pool_ = VK_NULL_HANDLE;
  VkDescriptorSet set_ = VK_NULL_HANDLE;
  VkPipelineLayout layout_ = VK_NULL_HANDLE;
  VkPipeline pipeline_ = VK_NULL_HANDLE;
};

}  // namespace sinew::viewer
