// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <string_view>
#include <vector>

#include "runtime/c/handles.h"
#include "runtime/c/scene.h"
#include "tests/scenes/hand_scenes.h"

namespace sinew::test {
namespace {

TEST(clip_annotations, events_and_curves_of_clips_are_read) {
  sinew_scene scene{arm_scene()};
  Annotations notes;
  notes.add_event(0.5, "clap");
  notes.curves = {{"tint", CurveBlend::mean, std::vector<CurveKey<glm::vec3>>{{0.0f, CurveStep::hold, {1, 2, 3}}}},
                  {"open", CurveBlend::mean, std::vector<CurveKey<bool>>{{0.0f, CurveStep::hold, true}}}};
  scene.scene.clips[0] = with_annotations(scene.scene.clips[0], notes);
  const auto text = [](sinew_string s) { return std::string_view(s.data, s.length); };
  const sinew_doubles times = sinew_clip_event_times(&scene, 0);
  ASSERT_EQ(times.count, 1u);
  EXPECT_EQ(times.data[0], 0.5);
  EXPECT_EQ(text(sinew_clip_event_name(&scene, 0, 0)), "clap");
  EXPECT_EQ(text(sinew_clip_event_name(&scene, 0, 1)), "");
  ASSERT_EQ(sinew_clip_curve_count(&scene, 0), 2u);
  EXPECT_EQ(text(sinew_clip_curve_name(&scene, 0, 1)), "open");
  float value[4] = {9, 9, 9, 9};
  EXPECT_EQ(sinew_clip_curve_value(&scene, 0, 0, 0.7, value), 3u);
  EXPECT_EQ(value[2], 3.0f);
  EXPECT_EQ(value[3], 9.0f);
  EXPECT_EQ(sinew_clip_curve_value(&scene, 0, 1, 0.7, value), 1u);
  EXPECT_EQ(value[0], 1.0f);
  EXPECT_EQ(sinew_clip_curve_value(&scene, 0, 2, 0.7, value), 0u);
  EXPECT_EQ(sinew_clip_curve_value(&scene, 0, 0, 0.7, nullptr), 0u);
  EXPECT_EQ(sinew_clip_event_times(nullptr, 0).count, 0u);
}

}  // namespace
}  // namespace sinew::test
