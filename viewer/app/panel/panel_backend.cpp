// SPDX-License-Identifier: MIT
#include "viewer/app/panel/panel_backend.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <imgui/backends/imgui_impl_glfw.h>
#include <imgui/backends/imgui_impl_vulkan.h>

#include "viewer/device/swapchain.h"

namespace sinew::viewer {
namespace {

void set_style(GLFWwindow* window) {
  ImGui::StyleColorsDark();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = style.FrameRounding = style.GrabRounding = 4.0f;
  style.WindowBorderSize = 0.0f;
  style.Colors[ImGuiCol_WindowBg].w = 0.85f;
  style.Colors[ImGuiCol_TitleBgActive] =
      style.Colors[ImGuiCol_TitleBg];  // the panel looks the same with and without focus
  float scale = 1.0f, vertical = 1.0f;
  glfwGetWindowContentScale(window, &scale, &vertical);
  style.ScaleAllSizes(scale);
  ImFontConfig font;
  font.SizePixels = 13.0f * scale;
  ImGui::GetIO().Fonts->AddFontDefault(&font);
}

}  // namespace

PanelBackend::PanelBackend(Device& device, const Swapchain& swapchain, GLFWwindow* window) : device_(device) {
  make_render_pass(swapchain.format());
  const VkDescriptorPoolSize one{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1};  // for the font
  VkDescriptorPoolCreateInfo pool{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  // Newer releases of Dear ImGui free their descriptor sets.
  pool.flags = VK_DESCRIPTOR_POOL_CREATE_FREE_DESCRIPTOR_SET_BIT;
  pool.maxSets = 1;
  pool.poolSizeCount = 1;
  pool.pPoolSizes = &one;
  must(vkCreateDescriptorPool(device.handle(), &pool, nullptr, &descriptors_), "making the panel's descriptors");

  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;  // do not write imgui.ini into the current folder
  set_style(window);
  ImGui_ImplGlfw_InitForVulkan(window, true);
  ImGui_ImplVulkan_InitInfo info{};
  info.Instance = device.instance();
  info.PhysicalDevice = device.physical();
  info.Device = device.handle();
  info.QueueFamily = device.queue_family();
  info.Queue = device.queue();
  info.DescriptorPool = descriptors_;
  info.MinImageCount = 2;
  info.ImageCount = 8;  // number of vertex buffers: at least one per frame in flight
  info.MSAASamples = VK_SAMPLE_COUNT_1_BIT;
  info.CheckVkResultFn = [](VkResult result) { must(result, "drawing the panel"); };
  ImGui_ImplVulkan_Init(&info, render_pass_);
#if IMGUI_VERSION_NUM >= 19000  // it uploads the font by itself
  ImGui_ImplVulkan_CreateFontsTexture();
#else
  device.run_now([](VkCommandBuffer commands) { ImGui_ImplVulkan_CreateFontsTexture(commands); });
  ImGui_ImplVulkan_DestroyFontUploadObjects();
#endif
  follow(swapchain);
}

PanelBackend::~PanelBackend() {
  vkDeviceWaitIdle(device_.handle());
  ImGui_ImplVulkan_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
  destroy_framebuffers();
  vkDestroyDescriptorPool(device_.handle(), descriptors_, nullptr);
  vkDestroyRenderPass(device_.handle(), render_pass_, nullptr);
}

// A classic render pass, because the Vulkan backend of ImGui 1.89 has no dynamic rendering.
void PanelBackend::make_render_pass(VkFormat format) {
  VkAttachmentDescription color{};
  color.format = format;
  color.samples = VK_SAMPLE_COUNT_1_BIT;
  color.loadOp = VK_ATTACHMENT_LOAD_OP_LOAD;
  color.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  color.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
  color.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
  color.initialLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
  color.finalLayout = VK_IMAGE_LAYOUT_PRESENT_SRC_KHR;
  const VkAttachmentReference reference{0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
  VkSubpassDescription subpass{};
  subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
  subpass.colorAttachmentCount = 1;
  subpass.pColorAttachments = &reference;
  VkSubpassDependency after_picture{};
  after_picture.srcSubpass = VK_SUBPASS_EXTERNAL;
  after_picture.srcStageMask = after_picture.dstStageMask = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT;
  after_picture.srcAccessMask = VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT;
  after_picture.dstAccessMask = VK_ACCESS_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT;
  VkRenderPassCreateInfo info{VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO};
  info.attachmentCount = 1;
  info.pAttachments = &color;
  info.subpassCount = 1;
  info.pSubpasses = &subpass;
  info.dependencyCount = 1;
  info.pDependencies = &after_picture;
  must(vkCreateRenderPass(device_.handle(), &info, nullptr, &render_pass_), "making the panel's render pass");
}

void PanelBackend::follow(const Swapchain& swapchain) {
  destroy_framebuffers();
  extent_ = swapchain.extent();
  for (std::uint32_t i = 0; i < swapchain.image_count(); ++i) {
    const VkImageView view = swapchain.view(i);
    VkFramebufferCreateInfo info{VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO};
    info.renderPass = render_pass_;
    info.attachmentCount = 1;
    info.pAttachments = &view;
    info.width = extent_.width;
    info.height = extent_.height;
    info.layers = 1;
    must(vkCreateFramebuffer(device_.handle(), &info, nullptr, &framebuffers_.emplace_back()),
         "making the panel's framebuffer");
  }
}

void PanelBackend::destroy_framebuffers() noexcept {
  for (const VkFramebuffer framebuffer : framebuffers_) vkDestroyFramebuffer(device_.handle(), framebuffer, nullptr);
  framebuffers_.clear();
}

void PanelBackend::begin() {
  ImGui_ImplVulkan_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
}

void PanelBackend::record(VkCommandBuffer commands, std::uint32_t image) {
  ImGui::Render();
  VkRenderPassBeginInfo info{VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO};
  info.renderPass = render_pass_;
  info.framebuffer = framebuffers_[image];
  info.renderArea.extent = extent_;
  vkCmdBeginRenderPass(commands, &info, VK_SUBPASS_CONTENTS_INLINE);
  ImGui_ImplVulkan_RenderDrawData(ImGui::GetDrawData(), commands);
  vkCmdEndRenderPass(commands);
}

bool PanelBackend::wants_mouse() const { return ImGui::GetIO().WantCaptureMouse; }

bool PanelBackend::wants_keys() const { return ImGui::GetIO().WantTextInput; }

}  // namespace sinew::viewer
