// SPDX-License-Identifier: MIT
#include "viewer/app/live_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/scenes/hand_scenes.h"

namespace sinew::viewer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::vector<PlanStage> small_plan() {
  return {{"sample", true, "a clip plays", 12, 640}, {"morph", false, "no mesh has targets", 0, 0}};
}

FrameResult frame(std::uint64_t number, std::span<const std::uint64_t> stage_ns) {
  FrameResult result;
  result.frame = number;
  result.stage_ns = stage_ns;
  return result;
}

const PlanRow& row(const LivePlan& live, std::string_view stage) {
  for (const PlanRow& row : live.rows())
    if (row.stage == stage) return row;
  static const PlanRow none;
  ADD_FAILURE() << stage << " has no row";
  return none;
}

TEST(live_plan, has_a_row_for_every_stage_in_the_order_of_the_work) {
  LivePlan live;
  live.drawn({}, {.passes = describe_passes({.opaque = true}, {})}, {});
  live.evaluated(small_plan(), frame(1, {}));
  std::vector<std::string> stages;
  for (const PlanRow& row : live.rows()) stages.push_back(row.stage);
  EXPECT_THAT(stages, ElementsAre("sample", "morph", "upload", "collect", "shadow", "normal_depth", "ssao",
                                  "blur_horizontal", "blur_vertical", "opaque", "outline", "ground", "behind",
                                  "transparent", "weighted", "exposure", "backdrop", "tonemap", "show", "overlay"));
  EXPECT_TRUE(row(live, "sample").runs);
  EXPECT_EQ(row(live, "sample").reason, "a clip plays");
  EXPECT_EQ(row(live, "sample").count, 12u);
  EXPECT_FALSE(row(live, "morph").runs);
}

TEST(live_plan, tells_the_modes_of_the_picture_before_its_passes) {
  LivePlan live;
  live.drawn({}, {.modes = describe_modes({.opaque = true, .smooth_edges = true}, {}, {})}, {});
  std::vector<std::string> modes;
  for (const PlanRow& row : live.rows())
    if (row.part == PlanPart::modes) modes.push_back(row.stage);
  EXPECT_THAT(modes, ElementsAre("samples", "texture filter", "quaternion normals", "tone curve", "backdrop"));
  EXPECT_TRUE(row(live, "samples").runs);
  EXPECT_EQ(row(live, "samples").count, 4u);
  EXPECT_LT(plan_text(live.rows()).find("modes of the picture"), plan_text(live.rows()).find("passes, on the GPU"));
}

TEST(live_plan, tells_what_a_frame_took_from_a_geometry_cache) {
  LivePlan live;
  const CacheFacts facts{.frames_loaded = 5, .window_frames = 40, .ns_per_vertex = 3.0, .late = 1};
  live.cache(facts, {.cache_frames_decoded = 2, .vertices_from_cache = 825});
  EXPECT_TRUE(row(live, "cache window").runs);
  EXPECT_EQ(row(live, "cache window").count, 2u);
  for (const char* part :
       {"2 frames decoded, 825 vertices; ", "window 5 of 40 frames", "3.0 ns a decoded vertex, pictures late: 1"})
    EXPECT_THAT(row(live, "cache window").reason, HasSubstr(part));
  live.cache(facts, {.vertices_from_cache = 825, .vertices_blended = 825});
  EXPECT_FALSE(row(live, "cache window").runs);
  EXPECT_THAT(row(live, "cache window").reason, HasSubstr("0 frames decoded, 825 vertices, 825 blended with the pose"));
}

TEST(live_plan, says_how_often_poses_are_evaluated) {
  const Scene scene = test::arm_scene();
  const Plan plan = compile_plan(lend(scene), {});
  UpdateLevels levels(plan, Updates::held);
  LivePlan live;
  levels.begin_frame(0.04, 0.01);
  live.updates(levels);
  live.evaluated(small_plan(), frame(1, {}));
  EXPECT_EQ(live.rows()[0].stage, "update rate");
  EXPECT_TRUE(row(live, "update rate").runs);
  EXPECT_EQ(row(live, "update rate").reason, "every 4th frame, held in between: 4 % of the picture's height");
  levels.begin_frame(0.9, 0.01);
  live.updates(levels);
  EXPECT_FALSE(row(live, "update rate").runs);
  EXPECT_THAT(plan_text(live.rows()), HasSubstr("every frame: 90 % of the picture's height"));
}

TEST(live_plan, times_are_means_in_which_the_first_frames_do_not_stay) {
  LivePlan live;
  const std::vector<PlanStage> plan = small_plan();
  std::uint64_t number = 0;
  const auto evaluate = [&](std::uint64_t ns) {
    const std::uint64_t stage_ns[] = {ns, 7};
    live.evaluated(plan, frame(++number, stage_ns));
  };
  evaluate(9000000);
  EXPECT_DOUBLE_EQ(row(live, "sample").time_us, 9000.0);
  evaluate(5000);
  evaluate(2000);
  EXPECT_DOUBLE_EQ(row(live, "sample").time_us, 2.0);
  evaluate(3000);
  EXPECT_DOUBLE_EQ(row(live, "sample").time_us, 2.1);
  EXPECT_EQ(row(live, "morph").timed, 0u) << "a stage that is left out takes no time";
  const std::uint64_t again[] = {500000, 0};
  live.evaluated(plan, frame(number, again));
  EXPECT_DOUBLE_EQ(row(live, "sample").time_us, 2.1) << "the same frame twice is one frame";
}

TEST(live_plan, that_forgets_begins_with_the_first_frame_of_another_plan) {
  LivePlan live;
  live.evaluated(small_plan(), frame(1, {}));
  live.forget();
  EXPECT_TRUE(live.rows().empty());
  const std::vector<PlanStage> other = {{"skin", true, "a mesh has a skin", 3, 40}};
  live.evaluated(other, frame(1, {}));
  ASSERT_EQ(live.rows().size(), 1u);
  EXPECT_EQ(row(live, "skin").reason, "a mesh has a skin");
}

TEST(live_plan, tells_what_was_uploaded_and_what_was_left_out) {
  LivePlan live;
  live.drawn({.written = 2, .unchanged = 1, .bytes = 2400, .time_us = 3.0}, {.drawn = 4, .out_of_view = 5, .hidden = 6},
             {});
  EXPECT_EQ(row(live, "upload").reason, "2400 bytes of deformed vertices, 1 are there unchanged");
  EXPECT_EQ(row(live, "collect").reason, "5 meshes out of view and 6 hidden are left out");
  EXPECT_EQ(row(live, "collect").count, 4u);
  live.drawn({.unchanged = 3}, {.modes = {{{"samples", false, "edges are not smoothed", 1}}}}, {});
  EXPECT_EQ(row(live, "samples").count, 1u) << "one a pixel";
  EXPECT_FALSE(row(live, "upload").runs);
  EXPECT_EQ(row(live, "upload").timed, 0u);
}

TEST(live_plan, becomes_a_table_of_text) {
  LivePlan live;
  const std::uint64_t stage_ns[] = {1500, 0};
  live.evaluated(small_plan(), frame(1, stage_ns));
  const PassTime passes[] = {{"opaque", 0.25}};
  live.drawn({}, {.passes = describe_passes({.opaque = true, .occlusion = false}, {.opaque_draws = 3})}, passes);
  const std::string text = plan_text(live.rows());
  EXPECT_THAT(text, HasSubstr("evaluation, on the CPU\n  sample           on          12        1.5 us  a clip plays\n"
                              "  morph            off          0                no mesh has targets\n"));
  EXPECT_THAT(text, HasSubstr("\npasses, on the GPU\n  shadow           off"));
  EXPECT_THAT(text, HasSubstr("  opaque           on           3      250.0 us  shades"));
}

TEST(pass_stages, agree_with_the_frame_graph_and_always_say_why) {
  for (std::uint32_t bits = 0; bits < 4096; ++bits)
    for (const Show show : {Show::color, Show::ao, Show::normals, Show::depth, Show::level}) {
      const FrameNeeds needs{.opaque = (bits & 1) != 0,
                             .blended = (bits & 2) != 0,
                             .weighted = (bits & 2048) != 0,
                             .overlay = (bits & 4) != 0,
                             .unlit = (bits & 256) != 0,
                             .gooch = (bits & 1024) != 0,
                             .shadows = (bits & 64) != 0,
                             .ambient = (bits & 8) != 0,
                             .occlusion = (bits & 16) != 0,
                             .blur = (bits & 32) != 0,
                             .auto_exposure = (bits & 512) != 0,
                             .ground = (bits & 128) != 0,
                             .backdrop = (bits & 128) == 0,
                             .shadows_kept = (bits & 3) == 3,
                             .show = show};
      const FrameGraph graph(needs);
      for (const PassStage& stage : describe_passes(needs, {9, 7, 3, 5, 2, {64, 48}, 700, 900, 800})) {
        EXPECT_EQ(stage.runs, graph.has(stage.pass)) << name_of(stage.pass) << ' ' << bits;
        EXPECT_GT(stage.reason.size(), 10u) << name_of(stage.pass) << ' ' << bits;
        EXPECT_EQ(stage.count > 0, stage.runs) << name_of(stage.pass) << ' ' << bits;
        if (stage.runs && stage.pass == Pass::ground) {
          EXPECT_EQ(stage.count, 1u);
        }
      }
    }
}

TEST(live_plan, has_no_stage_on_while_nothing_moves) {
  LivePlan live;
  const std::uint64_t stage_ns[] = {1500, 0};
  live.evaluated(small_plan(), frame(1, stage_ns), true);
  EXPECT_TRUE(row(live, "sample").runs) << "evaluated for this picture";
  live.evaluated(small_plan(), frame(1, stage_ns), true);
  EXPECT_FALSE(row(live, "sample").runs);
  EXPECT_EQ(row(live, "sample").timed, 0u);
  EXPECT_EQ(row(live, "sample").count, 0u);
  EXPECT_EQ(row(live, "sample").reason, "nothing moves: the last pose stays");
  EXPECT_EQ(row(live, "morph").reason, "no mesh has targets");
  live.evaluated(small_plan(), frame(2, stage_ns), false);
  EXPECT_TRUE(row(live, "sample").runs);
}

TEST(live_plan, interpolation_is_off_in_frames_that_are_evaluated) {
  LivePlan live;
  const std::vector<PlanStage> plan = {{"interpolate", true, "frames between updates are asked for", 5, 0}};
  const std::uint64_t stage_ns[] = {40};
  FrameResult exact = frame(1, stage_ns), between = frame(2, stage_ns);
  between.work.poses_interpolated = 1;
  live.evaluated(plan, exact);
  EXPECT_FALSE(row(live, "interpolate").runs);
  EXPECT_EQ(row(live, "interpolate").timed, 0u);
  EXPECT_EQ(row(live, "interpolate").reason, "this frame is evaluated, not one in between");
  live.evaluated(plan, between);
  EXPECT_TRUE(row(live, "interpolate").runs);
}

TEST(live_plan, has_no_time_for_a_pass_that_ran_in_an_earlier_picture_alone) {
  LivePlan live;
  const PassTime passes[] = {{"shadow", 2.0}, {"opaque", 0.25}};
  live.drawn({},
             {.passes = describe_passes({.opaque = true, .shadows = 1, .occlusion = false, .shadows_kept = true}, {})},
             passes);
  EXPECT_FALSE(row(live, "shadow").runs);
  EXPECT_EQ(row(live, "shadow").timed, 0u);
  EXPECT_THAT(row(live, "shadow").reason, HasSubstr("maps are kept"));
  EXPECT_EQ(row(live, "opaque").timed, 1u);
}

TEST(live_plan, tells_what_the_window_takes) {
  LivePlan live;
  live.presented({.wait_us = 3000.0, .panel_us = 200.0, .present_us = 50.0});
  EXPECT_EQ(row(live, "wait").time_us, 3000.0);
  EXPECT_EQ(row(live, "panel").time_us, 200.0);
  EXPECT_EQ(row(live, "present").time_us, 50.0);
  EXPECT_TRUE(row(live, "present").runs);
}

TEST(pass_stages, the_reason_is_the_one_thing_that_keeps_a_pass_out) {
  const auto why = [](const FrameNeeds& needs, Pass pass) {
    return std::string(describe_passes(needs, {})[static_cast<std::size_t>(pass)].reason);
  };
  EXPECT_THAT(why({.opaque = true, .occlusion = false}, Pass::ssao), HasSubstr("switched off"));
  EXPECT_THAT(why({.opaque = true, .ambient = false}, Pass::normal_depth), HasSubstr("no ambient light"));
  EXPECT_THAT(why({.opaque = false}, Pass::blur_vertical), HasSubstr("nothing opaque"));
  EXPECT_THAT(why({.opaque = true, .blur = false}, Pass::blur_vertical), HasSubstr("blur is switched off"));
  EXPECT_THAT(why({.opaque = true}, Pass::transparent), HasSubstr("nothing blended"));
  EXPECT_THAT(why({.opaque = true}, Pass::ground), HasSubstr("no ground is asked for"));
  EXPECT_THAT(why({.opaque = true, .no_ground = NoGround::nothing_darkens}, Pass::ground),
              HasSubstr("nothing darkens it"));
  EXPECT_THAT(why({.ground = true, .show = Show::ao}, Pass::ground), HasSubstr("a buffer instead"));
  EXPECT_THAT(why({}, Pass::tonemap), HasSubstr("nothing is in view"));
  EXPECT_THAT(why({}, Pass::opaque), HasSubstr("nothing is in view"));
  EXPECT_THAT(why({.blended = true}, Pass::opaque), HasSubstr("clears the picture"));
  EXPECT_THAT(why({}, Pass::backdrop), HasSubstr("no environment is seen"));
  EXPECT_THAT(why({.opaque = true}, Pass::shadow), HasSubstr("no light casts"));
  EXPECT_THAT(why({.shadows = true}, Pass::shadow), HasSubstr("nothing is in view"));
  EXPECT_THAT(why({.opaque = true, .shadows = true, .show = Show::ao}, Pass::shadow), HasSubstr("a buffer instead"));
  EXPECT_THAT(why({.opaque = true}, Pass::outline), HasSubstr("part of Gooch shading"));
  EXPECT_THAT(why({.gooch = true}, Pass::outline), HasSubstr("nothing opaque"));
  const FrameNeeds gooch{.opaque = true, .gooch = true, .ambient = false};
  EXPECT_THAT(why(gooch, Pass::normal_depth), HasSubstr("outlines read"));
  EXPECT_THAT(why(gooch, Pass::ssao), HasSubstr("Gooch shading counts no light"));
  EXPECT_THAT(why(gooch, Pass::shadow), HasSubstr("Gooch shading counts no light"));
  EXPECT_THAT(why({.opaque = true, .show = Show::depth}, Pass::normal_depth), HasSubstr("depth only"));
  EXPECT_THAT(why({.opaque = true}, Pass::exposure), HasSubstr("exposure is given"));
  EXPECT_THAT(why({.auto_exposure = true}, Pass::exposure), HasSubstr("nothing is in view"));
  EXPECT_THAT(why({.opaque = true, .auto_exposure = true, .show = Show::ao}, Pass::exposure),
              HasSubstr("a buffer instead"));
  EXPECT_THAT(why({.opaque = true, .unlit = true}, Pass::tonemap), HasSubstr("unlit ones stay"));
  EXPECT_THAT(why({.opaque = true}, Pass::tonemap), Not(HasSubstr("unlit")));
}

}  // namespace
}  // namespace sinew::viewer
