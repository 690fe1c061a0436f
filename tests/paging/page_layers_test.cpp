// SPDX-License-Identifier: MIT
// Layers of characters that play paged clips.
#include <gtest/gtest.h>

#include <memory>

#include "runtime/paging/paged_clip.h"
#include "runtime/plan/joint_scales.h"
#include "runtime/plan/run_plan.h"
#include "tests/paging/pages.h"
#include "tests/plan/frame_equality.h"
#include "tests/scenes/random_inputs.h"
#include "tests/support/tiny_assets.h"

namespace sinew::test {
namespace {

constexpr double kLayerPage_s = 0.3;

/// The clips of a scene as PagedClips whose pages are loaded as soon as they are needed.
class Pages {
 public:
  explicit Pages(const Scene& scene, const std::vector<std::uint32_t>& kept_joints = {}) : clips_(scene.clips) {
    for (const Clip& clip : clips_)
      paged_.push_back(std::make_unique<PagedClip>(first_keys(clip), kLayerPage_s,
                                                   page_count_of(clip.duration_s(), kLayerPage_s),
                                                   PagedClip::Options{.kept_joints = kept_joints}));
  }

  std::vector<ClipLayer> of(std::span<const ClipLayer> layers) {
    std::vector<ClipLayer> paged(layers.begin(), layers.end());
    for (ClipLayer& layer : paged) {
      PagedClip& clip = *paged_[layer.clip];
      clip.at(layer.time_s);
      while (const auto page = clip.next_page())
        EXPECT_TRUE(clip.load_page(*page, pages_of(clips_[layer.clip], kLayerPage_s)[*page]));
      held_.push_back(std::make_unique<PageSample>(clip.at(layer.time_s)));
      EXPECT_FALSE(held_.back()->is_missing);
      layer.page = &held_.back()->page;
    }
    return paged;
  }
  void frame_has_run() { held_.clear(); }

 private:
  std::vector<Clip> clips_;
  std::vector<std::unique_ptr<PagedClip>> paged_;
  std::vector<std::unique_ptr<PageSample>> held_;
};

TEST(page_layers, frames_from_pages_have_the_bits_of_frames_from_whole_clips) {
  std::size_t frames = 0;
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u, 5u, 6u}) {
    const Scene scene = busy_scene(seed);
    const Plan plan = compile_plan(lend(scene), busy_needs(seed, scene));
    FrameBuffer whole(plan), paged(plan);
    Pages pages(scene, kept_joints(plan));
    RandomInputs inputs(plan);
    for (std::uint32_t step = 0; step < 60; ++step, ++frames) {
      inputs.step(static_cast<std::uint32_t>(seed * 1000 + step));
      FrameInput input = inputs.view();
      ASSERT_EQ(run_plan(plan, input, whole), ErrorCode::ok);
      const std::vector<ClipLayer> layers = pages.of(input.layers), next = pages.of(input.next_layers);
      input.layers = layers;
      input.next_layers = next;
      ASSERT_EQ(run_plan(plan, input, paged), ErrorCode::ok);
      ASSERT_EQ(first_difference(whole.result(), paged.result()), "") << "seed " << seed << ", step " << step;
      ASSERT_EQ(whole.result().work.tracks_sampled, paged.result().work.tracks_sampled);
      pages.frame_has_run();
    }
  }
  EXPECT_GE(frames, 360u);
}

TEST(page_layers, pages_for_a_plan_with_a_skeleton_lod_have_the_bits_of_its_whole_clips) {
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
    const Scene scene = busy_scene(seed);
    Needs needs;
    needs.out.skeleton_lod.kept.resize(scene.skeleton.joint_count());
    for (std::size_t j = 0; j < needs.out.skeleton_lod.kept.size(); ++j) needs.out.skeleton_lod.kept[j] = j % 5 == 1;
    const Plan plan = compile_plan(lend(scene), needs);
    ASSERT_LT(kept_joints(plan).size(), scene.skeleton.joint_count()) << seed;
    FrameBuffer whole(plan), paged(plan);
    Pages pages(scene, kept_joints(plan));
    for (double t = 0.0; t < scene.clips[0].duration_s(); t += 0.07) {
      const ClipLayer layer{.clip = 0, .time_s = t};
      const std::vector<ClipLayer> layers = pages.of({&layer, 1});
      ASSERT_EQ(run_plan(plan, {.layers = {&layer, 1}, .weights = {}, .root = {}}, whole), ErrorCode::ok);
      ASSERT_EQ(run_plan(plan, {.layers = layers, .weights = {}, .root = {}}, paged), ErrorCode::ok);
      ASSERT_EQ(first_difference(whole.result(), paged.result()), "") << t;
      pages.frame_has_run();
    }
    PagedClip nothing_loaded(first_keys(scene.clips[0]), kLayerPage_s, 9, {.kept_joints = kept_joints(plan)});
    const PageSample start = nothing_loaded.at(1.0);
    const ClipLayer from_head{.clip = 0, .time_s = start.time_s, .page = &start.page}, from_clip{.clip = 0};
    ASSERT_EQ(run_plan(plan, {.layers = {&from_head, 1}, .weights = {}, .root = {}}, paged), ErrorCode::ok);
    ASSERT_EQ(run_plan(plan, {.layers = {&from_clip, 1}, .weights = {}, .root = {}}, whole), ErrorCode::ok);
    EXPECT_EQ(first_difference(whole.result(), paged.result()), "") << "the start";
  }
}

TEST(page_layers, a_plan_compiled_with_first_keys_plays_all_pages) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    Scene scene = busy_scene(seed), heads = scene;
    for (Clip& clip : heads.clips) clip = first_keys(clip);
    const Plan plan = compile_plan(lend(scene), {}), paged_plan = compile_plan(lend(heads), {});
    FrameBuffer whole(plan), paged(paged_plan);
    Pages pages(scene);
    for (double t = 0.0; t < scene.clips[0].duration_s(); t += 0.07) {
      const ClipLayer layer{.clip = 0, .time_s = t};
      const std::vector<ClipLayer> layers = pages.of({&layer, 1});
      ASSERT_EQ(run_plan(plan, {.layers = {&layer, 1}, .weights = {}, .root = {}}, whole), ErrorCode::ok);
      ASSERT_EQ(run_plan(paged_plan, {.layers = layers, .weights = {}, .root = {}}, paged), ErrorCode::ok);
      ASSERT_TRUE(same_bits<Affine>(whole.result().model, paged.result().model)) << t;
      ASSERT_TRUE(same_bits<float>(whole.result().weights, paged.result().weights)) << t;
      ASSERT_TRUE(same_bits<float>(whole.result().properties, paged.result().properties)) << t;
      pages.frame_has_run();
    }
  }
}

/// Scales decide normals and winding. Keys that a plan does not see may have any scale.
TEST(page_layers, a_plan_expects_any_scale_of_keys_that_are_elsewhere) {
  const Vec3Track grows{
      Interpolation::linear, {0.0f, 1.0f, 2.0f}, {glm::vec3(1.0f), glm::vec3(1.0f), glm::vec3(1.0f, -2.0f, 1.0f)}};
  const Skeleton skeleton = chain_skeleton(2);
  Scene scene;
  scene.skeleton = skeleton;
  scene.first_weight = {0};
  scene.animations = {animation_of({{.joint = 0, .scale = grows}})};
  finish_scene(scene);
  for (Clip& clip : scene.clips) clip = first_keys(clip);
  const JointScale scale = joint_scales(make_assets(scene, scene.clips, {}), false)[1];
  EXPECT_EQ(scale.kind, ScaleKind::uneven);
  EXPECT_TRUE(scale.may_change);
}

TEST(page_layers, a_page_of_another_size_is_refused) {
  const Scene scene = busy_scene(1);
  const Plan plan = compile_plan(lend(scene), {});
  FrameBuffer frame(plan);
  const Clip other = clip_of({}, chain_skeleton(static_cast<std::uint32_t>(scene.skeleton.joint_count() + 1)));
  const ClipLayer layer{.clip = 0, .page = &other};
  EXPECT_EQ(run_plan(plan, {.layers = {&layer, 1}, .weights = {}, .root = {}}, frame), ErrorCode::wrong_page);
}

}  // namespace
}  // namespace sinew::test
