// SPDX-License-Identifier: MIT
#include "viewer/app/frame.h"

#include <chrono>

namespace sinew::viewer {
namespace {

using Clock = std::chrono::steady_clock;

double microseconds_since(Clock::time_point then) {
  return std::chrono::duration<double, std::micro>(Clock::now() - then).count();
}

}  // namespace

Frame::Frame(Device& device, Swapchain& swapchain, PanelBackend& panel)
    : device_(device), swapchain_(swapchain), panel_(panel), renderer_(device, swapchain.format(), kSlots) {
  for (Slot& slot : slots_) {
    VkCommandPoolCreateInfo pool{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    pool.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
    pool.queueFamilyIndex = device.queue_family();
    must(vkCreateCommandPool(device.handle(), &pool, nullptr, &slot.pool), "making a command pool");
    VkCommandBufferAllocateInfo commands{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
    commands.commandPool = slot.pool;
    commands.commandBufferCount = 1;
    must(vkAllocateCommandBuffers(device.handle(), &commands, &slot.commands), "making a command buffer");
    VkFenceCreateInfo fence{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
    fence.flags = VK_FENCE_CREATE_SIGNALED_BIT;
    must(vkCreateFence(device.handle(), &fence, nullptr, &slot.done), "making a fence");
    const VkSemaphoreCreateInfo semaphore{VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO};
    must(vkCreateSemaphore(device.handle(), &semaphore, nullptr, &slot.image_ready), "making a semaphore");
  }
}

Frame::~Frame() {
  vkDeviceWaitIdle(device_.handle());
  for (const Slot& slot : slots_) {
    vkDestroySemaphore(device_.handle(), slot.image_ready, nullptr);
    vkDestroyFence(device_.handle(), slot.done, nullptr);
    vkDestroyCommandPool(device_.handle(), slot.pool, nullptr);
  }
}

bool Frame::draw(ShownScene& shown, const View& view, const RenderOptions& options, const Settings& settings,
                 const std::function<void()>& lay_out) {
  const Slot& slot = slots_[next_];
  const Clock::time_point start = Clock::now();
  must(vkWaitForFences(device_.handle(), 1, &slot.done, VK_TRUE, ~std::uint64_t{0}), "waiting for a frame");
  const auto image = swapchain_.acquire(slot.image_ready);
  if (!image) return false;
  window_times_.wait_us = microseconds_since(start);
  const auto times = renderer_.pass_times(next_);
  pass_times_.assign(times.begin(), times.end());

  const DrawnScene drawn = shown.upload(next_, settings.variant);
  FrameInputs inputs;
  inputs.slot = next_;
  inputs.scenes = {&drawn, 1};
  inputs.view = view;
  inputs.options = options;
  inputs.lines = shown.lines(settings.inspected, settings.skeleton);
  ColorTarget target;
  target.image = swapchain_.image(*image);
  target.view = swapchain_.view(*image);
  target.extent = swapchain_.extent();
  target.final_layout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;  // because the panel is drawn on top next

  begin(slot);
  renderer_.record(slot.commands, target, inputs);
  report_ = renderer_.report(next_);
  const Clock::time_point panel = Clock::now();
  panel_.begin();
  lay_out();
  panel_.record(slot.commands, *image);
  window_times_.panel_us = microseconds_since(panel);
  submit(slot, *image);
  const Clock::time_point present = Clock::now();
  swapchain_.present(*image);
  window_times_.present_us = microseconds_since(present);
  next_ = (next_ + 1) % kSlots;
  return true;
}

void Frame::begin(const Slot& slot) const {
  must(vkResetCommandPool(device_.handle(), slot.pool, 0), "reusing a command pool");
  VkCommandBufferBeginInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
  info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  must(vkBeginCommandBuffer(slot.commands, &info), "beginning a frame");
}

void Frame::submit(const Slot& slot, std::uint32_t image) const {
  must(vkEndCommandBuffer(slot.commands), "ending a frame");
  must(vkResetFences(device_.handle(), 1, &slot.done), "reusing a fence");
  const VkPipelineStageFlags wait_stage = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT;
  const VkSemaphore drawn = swapchain_.drawn(image);
  VkSubmitInfo info{VK_STRUCTURE_TYPE_SUBMIT_INFO};
  info.waitSemaphoreCount = 1;
  info.pWaitSemaphores = &slot.image_ready;
  info.pWaitDstStageMask = &wait_stage;
  info.commandBufferCount = 1;
  info.pCommandBuffers = &slot.commands;
  info.signalSemaphoreCount = 1;
  info.pSignalSemaphores = &drawn;
  must(vkQueueSubmit(device_.queue(), 1, &info, slot.done), "drawing a frame");
}

std::span<const PassTime> Frame::pass_times() { return pass_times_; }

}  // namespace sinew::viewer
