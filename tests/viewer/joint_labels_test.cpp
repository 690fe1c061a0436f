// SPDX-License-Identifier: MIT
// Names of joints beside them, in scenes without meshes.
#include <imgui.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/viewer/imgui_fixture.h"
#include "viewer/app/panel/joint_labels.h"

namespace sinew::viewer {
namespace {

class joint_labels : public ImguiTest {
 protected:
  joint_labels() {
    scene_.skeleton.parents = {kNone, 0, 0};
    scene_.skeleton.names = {"root", "tip", "behind"};
    model_[1].row[0].w = 1.0f;
    model_[2].row[2].w = 9.0f;
  }

  /// Corners of the letters, in pixels.
  std::vector<ImVec2> letters() {
    ImGui::NewFrame();
    lay_out_joint_labels(scene_, model_, look_at({0, 0, 4}, {0, 0, 0}, 0.8, 0.1));
    std::vector<ImVec2> corners;
    for (const ImDrawVert& v : ImGui::GetBackgroundDrawList()->VtxBuffer) corners.push_back(v.pos);
    ImGui::EndFrame();
    return corners;
  }

  Scene scene_;
  std::vector<Affine> model_ = std::vector<Affine>(3);
};

TEST_F(joint_labels, are_beside_each_joint_before_the_viewer) {
  const std::vector<ImVec2> corners = letters();
  EXPECT_EQ(corners.size(), 4u * 7) << "root and tip";
  const float tip = 640.0f * (1.0f + 1.0f / (4.0f * 0.42279f * 1280.0f / 720.0f));
  const auto beside = [&](float x) {
    return std::count_if(corners.begin(), corners.end(), [&](const ImVec2& at) {
      return at.x > x && at.x < x + 60.0f && std::abs(at.y - 360.0f) < 12.0f;
    });
  };
  EXPECT_EQ(beside(640.0f), 16);
  EXPECT_EQ(beside(tip), 12);
}

TEST_F(joint_labels, leave_out_a_name_that_would_cover_another) {
  model_[1] = model_[0];
  EXPECT_EQ(letters().size(), 4u * 4);
}

TEST_F(joint_labels, are_not_shown_over_meshes) {
  scene_.instances.emplace_back();
  EXPECT_TRUE(letters().empty());
}

}  // namespace
}  // namespace sinew::viewer
