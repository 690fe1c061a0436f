// SPDX-License-Identifier: MIT
#pragma once
#include <gtest/gtest.h>
#include <imgui.h>

namespace sinew::viewer {

/// Base of tests of the panels: ImGui without window or device. Panels are laid out and can be clicked, but are not
/// drawn.
class ImguiTest : public testing::Test {
 protected:
  ImguiTest() : context_(ImGui::CreateContext()) {
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {1280, 720};
    io.DeltaTime = 1.0f / 60.0f;
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    io.Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
  }
  ~ImguiTest() override { ImGui::DestroyContext(context_); }

  ImGuiContext* context_;
};

}  // namespace sinew::viewer
