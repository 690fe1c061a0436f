// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <optional>

#include "runtime/library/clip_library.h"
#include "runtime/plan/run_plan.h"
#include "tests/library/named_scene.h"
#include "tests/plan/frame_equality.h"

namespace sinew::test {
namespace {

Plan plan_for(const ClipLibrary& library, const Scene& scene) {
  return compile_plan(scene, clips_for(library, scene).clips, Needs{});
}

void play(const Plan& plan, std::uint32_t clip, double time_s, FrameBuffer& frame) {
  const ClipLayer layers[] = {{.clip = clip, .time_s = time_s, .weight = 0.75f}, {.clip = 0, .time_s = 0.1}};
  ASSERT_EQ(run_plan(plan, {.layers = layers}, frame), ErrorCode::ok);
}

/// The first difference between this frame and the frame of a plan with the scene's own clips; empty if there is none.
std::string difference_from_own(const Scene& scene, const FrameBuffer& frame, std::uint32_t clip, double time_s) {
  const Plan plan = compile_plan(scene, Needs{});
  FrameBuffer own(plan);
  play(plan, clip, time_s, own);
  return first_difference(frame.result(), own.result());
}

TEST(growing_library, frames_of_a_library_have_the_bits_of_frames_of_the_own_clips) {
  const Scene scene = named_scene(1), file = reordered(scene);
  ClipLibrary library(scene.skeleton);
  library.add(file);
  const Plan plan = plan_for(library, scene);
  FrameBuffer frame(plan);
  for (double t = 0.0; t < 1.0; t += 0.1) {
    play(plan, 1, t, frame);
    EXPECT_EQ(difference_from_own(scene, frame, 1, t), "") << t;
  }
}

TEST(growing_library, plans_outlive_the_library_and_their_clips) {
  const Scene scene = named_scene(2);
  std::optional<Scene> file = reordered(scene);
  std::optional<ClipLibrary> library(scene.skeleton);
  library->add(*file);
  const Plan plan = plan_for(*library, scene);
  library.reset();
  file.reset();
  FrameBuffer frame(plan);
  play(plan, 1, 0.4, frame);
  EXPECT_EQ(difference_from_own(scene, frame, 1, 0.4), "");
}

TEST(growing_library, a_version_keeps_its_clips_and_later_ones_keep_their_indices) {
  const Scene scene = named_scene(3);
  ClipLibrary first(scene.skeleton);
  first.add(scene);
  ClipLibrary second = first;
  second.add(reordered(scene));
  EXPECT_EQ(first.size(), scene.clips.size());
  ASSERT_EQ(second.size(), 2 * scene.clips.size());
  for (std::size_t c = 0; c < first.size(); ++c) EXPECT_EQ(&first[c].layout(), &second[c].layout());
  const BoundClips bound = clips_for(second, scene);
  ASSERT_EQ(bound.clips.size(), second.size()) << "each once";
  for (std::size_t c = 0; c < second.size(); ++c) EXPECT_EQ(bound.clips[c].name(), second[c].name()) << c;
}

TEST(growing_library, characters_go_over_to_the_plan_of_the_next_version_without_a_jump) {
  const Scene scene = named_scene(4);
  ClipLibrary library(scene.skeleton);
  library.add(scene);
  const Plan before = plan_for(library, scene);
  FrameBuffer old_frame(before), still_running(before);
  for (double t = 0.0; t < 0.45; t += 0.1) play(before, 1, t, old_frame);

  library.add(reordered(scene));
  const Plan after = plan_for(library, scene);
  FrameBuffer frame(after);
  frame.count_from(old_frame.result().frame);
  play(after, 1, 0.5, frame);
  EXPECT_EQ(frame.result().frame, old_frame.result().frame + 1);
  EXPECT_EQ(difference_from_own(scene, frame, 1, 0.5), "");
  play(after, 3, 0.5, frame);  // the same clip from the other file
  EXPECT_EQ(difference_from_own(scene, frame, 1, 0.5), "");
  play(before, 1, 0.5, still_running);
  EXPECT_EQ(difference_from_own(scene, still_running, 1, 0.5), "");
}

TEST(growing_library, plans_do_not_run_clips_that_their_version_has_not) {
  const Scene scene = named_scene(5);
  ClipLibrary library(scene.skeleton);
  library.add(scene);
  const Plan plan = plan_for(library, scene);
  library.add(scene);
  FrameBuffer frame(plan);
  const ClipLayer layer{.clip = 2};
  EXPECT_EQ(run_plan(plan, {.layers = {&layer, 1}}, frame), ErrorCode::index_out_of_range);
}

}  // namespace
}  // namespace sinew::test
