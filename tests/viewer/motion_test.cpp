// SPDX-License-Identifier: MIT
// Layers, root motion, springs and graphs: the pose programs that the viewer writes, beside poses of the plain runtime.
#include "viewer/app/motion/motion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "runtime/model/mirror_scene.h"
#include "runtime/plan/run_plan.h"
#include "samples/showcase/scene_builder.h"
#include "viewer/app/motion/layer_choice.h"

namespace sinew::viewer {
namespace {

using testing::HasSubstr;

glm::quat turn(float angle_rad, const glm::vec3& axis) {
  return {std::cos(0.5f * angle_rad), std::sin(0.5f * angle_rad) * axis.x, std::sin(0.5f * angle_rad) * axis.y,
          std::sin(0.5f * angle_rad) * axis.z};
}

BoneAnimation bends(std::uint32_t joint, float from, float to, float duration_s) {
  BoneAnimation bone;
  bone.joint = joint;
  bone.rotation.times_s = {0.0f, duration_s};
  bone.rotation.values = {turn(from, {0, 0, 1}), turn(to, {0, 0, 1})};
  return bone;
}

/// A frame whose z axis points up, a root that walks along its -y (world z), a spine, and an arm on each side. "walk"
/// lasts 2 s and goes 3 m; "wave" lasts 1 s.
Scene walker() {
  showcase::SceneBuilder builder;
  Transform upright;
  upright.rotation = turn(-std::numbers::pi_v<float> / 2, {1, 0, 0});
  const std::uint32_t frame = builder.add_joint("frame", kNone, upright), root = builder.add_joint("root", frame, {});
  Transform up, left, right;
  up.translation = {0, 0, 1};
  left.translation = {0.3f, 0, 0.2f};
  right.translation = {-0.3f, 0, 0.2f};
  const std::uint32_t spine = builder.add_joint("spine", root, up);
  const std::uint32_t arm_l = builder.add_joint("arm_l", spine, left), arm_r = builder.add_joint("arm_r", spine, right);
  BoneAnimation walks;
  walks.joint = root;
  walks.translation.times_s = {0.0f, 2.0f};
  walks.translation.values = {{0, 0, 0}, {0, -3, 0.25f}};
  builder.add_animation({"walk", 2.0, {walks, bends(spine, 0.0f, 0.4f, 2.0f), bends(arm_l, 0.1f, 0.3f, 2.0f)}, {}});
  builder.add_animation({"wave", 1.0, {bends(spine, 0.2f, 0.1f, 1.0f), bends(arm_l, -0.5f, 0.9f, 1.0f)}, {}});
  (void)arm_r;
  return builder.finish();
}

std::shared_ptr<const CharacterRig> rig_of(const Scene& scene) {
  std::vector<std::string> left_out;
  return std::make_shared<const CharacterRig>(make_rig(scene, nullptr, left_out));
}

std::vector<Transform> local_of(const FrameResult& frame) {
  std::vector<Transform> local;
  for (std::size_t j = 0; j < frame.model.size(); ++j) local.push_back(frame.local.get(j));
  return local;
}

/// The pose of plain layers.
std::vector<Transform> layered(const Scene& scene, std::vector<ClipLayer> layers) {
  Needs needs;
  needs.in.additive = true;
  needs.in.mirror = std::make_shared<const MirrorMap>(make_mirror_map(scene));
  const Plan plan = compile_plan(lend(scene), needs);
  FrameBuffer buffer(plan);
  FrameInput input;
  input.layers = layers;
  EXPECT_EQ(run_plan(plan, input, buffer), ErrorCode::ok);
  return local_of(buffer.result());
}

/// Plays a motion of a scene.
struct Player {
  Player(const Scene& of, std::shared_ptr<const CharacterRig> rig, const MotionSettings& settings)
      : motion(of, rig, settings), plan(compile_plan(lend(of), needs(of, rig.get(), motion.shape()))), buffer(plan) {}

  static Needs needs(const Scene& of, const CharacterRig* rig, const MotionShape& shape) {
    Needs needs;
    add_motion_needs(shape, of, rig, needs);
    return needs;
  }
  const FrameResult& at(const MotionMoment& moment) {
    FrameInput input;
    motion.write(moment, input);
    EXPECT_EQ(run_plan(plan, input, buffer), ErrorCode::ok);
    return buffer.result();
  }
  Motion motion;
  Plan plan;
  FrameBuffer buffer;
};

void expect_near(const Transform& a, const Transform& b, const char* what) {
  const float same = std::abs(glm::dot(a.rotation, b.rotation));
  EXPECT_NEAR(same, 1.0f, 1e-6f) << what;
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(a.translation[i], b.translation[i], 1e-6f) << what;
}

TEST(motion, a_layer_that_covers_takes_its_joints_and_leaves_the_others) {
  const Scene scene = walker();
  MotionSettings settings;
  settings.layers = {{1, 1.0f, *scene.skeleton.find("arm_l")}};
  Player player(scene, rig_of(scene), settings);
  const auto pose = local_of(player.at({.clip = 0, .time_s = 0.5}));
  // A quarter of the walk has passed, so the wave is at a quarter of its second, too.
  const auto walk = layered(scene, {{0, 0.5}}), wave = layered(scene, {{1, 0.25}});
  const std::uint32_t arm = *scene.skeleton.find("arm_l");
  for (std::uint32_t j = 0; j < pose.size(); ++j) expect_near(pose[j], (j == arm ? wave : walk)[j], "joint");
  settings.layers[0].weight = 0.0f;
  player.motion.set(settings);
  expect_near(local_of(player.at({.clip = 0, .time_s = 0.5}))[arm], walk[arm], "weight 0");
}

TEST(motion, layers_that_add_and_mirrored_clips_are_those_of_the_runtime) {
  const Scene scene = walker();
  for (const auto& [use, kind] : {std::pair(LayerUse::add_to_rest, LayerKind::add_to_rest),
                                  std::pair(LayerUse::add_to_start, LayerKind::add_to_start)}) {
    MotionSettings settings;
    settings.mirrored = true;
    settings.layers = {{1, 0.7f, kNone, true, use}};
    Player player(scene, rig_of(scene), settings);
    const auto pose = local_of(player.at({.clip = 0, .time_s = 1.0}));
    const auto truth = layered(scene, {{.clip = 0, .time_s = 1.0, .mirrored = true},
                                       {.clip = 1, .time_s = 0.5, .weight = 0.7f, .kind = kind, .mirrored = true}});
    for (std::size_t j = 0; j < pose.size(); ++j) expect_near(pose[j], truth[j], "joint");
  }
}

TEST(motion, a_cross_fade_goes_from_the_clip_before_to_the_chosen_one) {
  const Scene scene = walker();
  MotionSettings settings;
  settings.fade_s = 1.0f;
  Player player(scene, rig_of(scene), settings);
  const std::uint32_t arm = *scene.skeleton.find("arm_l");
  const MotionMoment moment{.clip = 1, .time_s = 0.2, .faded_clip = 0, .faded_time_s = 0.5, .fade = 0.0f};
  expect_near(local_of(player.at(moment))[arm], layered(scene, {{0, 0.5}})[arm], "before");
  MotionMoment after = moment;
  after.fade = 1.0f;
  expect_near(local_of(player.at(after))[arm], layered(scene, {{1, 0.2}})[arm], "after");
  after.fade = 0.5f;
  expect_near(local_of(player.at(after))[arm], layered(scene, {{0, 0.5, 0.5f}, {1, 0.2, 0.5f}})[arm], "half way");
}

TEST(motion, the_root_stays_in_place_or_moves_on_over_rounds_whatever_axis_is_up) {
  const Scene scene = walker();
  const auto rig = rig_of(scene);
  ASSERT_EQ(rig->root.joint, *scene.skeleton.find("root"));
  EXPECT_FALSE(rig->root.parts.z) << "z is up in its parent";
  const auto root_at = [&](RootPlay root, double played_s) {
    MotionSettings settings;
    settings.root = root;
    settings.layers = {{1, 0.0f}};  // so that a program is written for as_in_clip, too
    Player player(scene, rig, settings);
    return translation_of(player.at(moment_at(scene, 0, played_s)).model[rig->root.joint]);
  };
  const auto is_at = [](const glm::vec3& at, float y, float z) {
    return std::abs(at.x) < 1e-5f && std::abs(at.y - y) < 1e-5f && std::abs(at.z - z) < 1e-5f;
  };
  EXPECT_TRUE(is_at(root_at(RootPlay::as_in_clip, 1.0), 0.125f, 1.5f));
  EXPECT_TRUE(is_at(root_at(RootPlay::in_place, 1.0), 0.125f, 0.0f)) << "its height stays in the pose";
  EXPECT_TRUE(is_at(root_at(RootPlay::moving, 1.0), 0.125f, 1.5f));
  EXPECT_TRUE(is_at(root_at(RootPlay::as_in_clip, 7.0), 0.125f, 1.5f));
  EXPECT_TRUE(is_at(root_at(RootPlay::moving, 7.0), 0.125f, 10.5f)) << "three rounds and a half";
}

TEST(motion, springs_swing_behind_the_clip_and_rest_where_they_are_switched_off) {
  const Scene scene = walker();
  SpringSetup setup;
  setup.groups.emplace_back();
  SpringJoint like;
  like.stiffness = 0.5f;
  like.drag = 0.4f;
  add_chain_below(scene.skeleton, *scene.skeleton.find("arm_l"), like, 0.2, setup);
  CharacterRig rig = *rig_of(scene);
  rig.springs = compile_springs(scene.skeleton, setup).value();
  const auto shared = std::make_shared<const CharacterRig>(rig);
  const std::uint32_t arm = *scene.skeleton.find("arm_l");
  const auto swung = [&](bool springs) {
    MotionSettings settings;
    settings.springs = springs;
    settings.layers = {{1, 0.0f}};
    Player player(scene, shared, settings);
    player.motion.reset_springs();
    for (int frame = 0; frame <= 30; ++frame)
      (void)player.at({.clip = 0, .time_s = frame / 60.0, .dt_s = frame == 0 ? 0.0 : 1.0 / 60.0});
    EXPECT_EQ(player.motion.is_swinging(), springs);
    return local_of(player.buffer.result())[arm];
  };
  const Transform clip = layered(scene, {{0, 0.5}})[arm], moved = swung(true);
  EXPECT_LT(std::abs(glm::dot(moved.rotation, clip.rotation)), 0.9999f);
  EXPECT_EQ(moved.rotation, swung(true).rotation) << "the same from run to run";
  expect_near(swung(false), clip, "off");
}

constexpr const char* kGraph = R"({"graph": 1, "root": "body", "parameters": {"go": {"kind": "flag"}},
  "masks": {"arm": ["arm_l"]},
  "nodes": {"body": {"kind": "machine", "initial": "stand",
      "states": {"stand": {"node": "wave", "transitions": [{"to": "walk", "when": [{"kind": "on", "parameter": "go"}], "duration_s": 0.5}]},
                 "walk": {"node": "walk"}}},
    "wave": {"kind": "clip", "clip": "wave"}, "walk": {"kind": "clip", "clip": "walk"}}})";

class graph_motion : public testing::Test {
 protected:
  tl::expected<std::shared_ptr<const GraphOnScene>, std::string> read(const std::string& text,
                                                                      std::vector<GraphSetting> script = {}) {
    std::ofstream(file_) << text;
    return read_graph_for(file_, scene_, find_root_joint(scene_), std::move(script));
  }
  void TearDown() override { std::filesystem::remove(file_); }

  Scene scene_ = walker();
  std::string file_ = (std::filesystem::temp_directory_path() / ("graph" + std::to_string(::getpid()))).string();
};

TEST_F(graph_motion, follows_its_script_in_any_steps_and_back_again) {
  const auto graph = read(kGraph, {{1.0, "go", 1.0f}});
  ASSERT_TRUE(graph) << graph.error();
  GraphPlayer once(*graph), often(*graph);
  once.seek(2.0);
  for (int i = 1; i <= 200; ++i) often.seek(i * 0.01);
  const auto same = [](PoseProgramSpan a, PoseProgramSpan b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  };
  EXPECT_TRUE(same(once.program(), often.program()));
  EXPECT_NEAR(translation_of(once.world()).y, -1.5, 0.4) << "it walks for a second, and fades in for half of it";
  EXPECT_NEAR(translation_of(once.world()).y, translation_of(often.world()).y, 1e-6);
  ASSERT_EQ(once.states().size(), 1u);
  EXPECT_EQ(once.state_name(once.states()[0]), "walk");
  often.seek(0.5);
  ASSERT_EQ(often.states().size(), 1u);
  EXPECT_EQ(often.state_name(often.states()[0]), "stand");
  EXPECT_EQ(translation_of(often.world()).y, 0.0);
  often.seek(2.0);
  EXPECT_TRUE(same(once.program(), often.program())) << "the script happens again";
}

TEST_F(graph_motion, moves_the_character_by_its_program) {
  CharacterRig rig = *rig_of(scene_);
  rig.graph = read(kGraph, {{0.0, "go", 1.0f}}).value();
  Player player(scene_, std::make_shared<const CharacterRig>(rig), {});
  ASSERT_TRUE(player.motion.writes_program());
  const double z = static_cast<double>(translation_of(player.at({.time_s = 5.0}).model[rig.root.joint]).z);
  EXPECT_NEAR(z, -translation_of(player.motion.graph()->world()).y, 1e-4);
  EXPECT_GT(z, 6.0) << "two rounds and a half of 3 m, less the fade";
}

TEST_F(graph_motion, a_parameter_set_in_the_window_takes_effect_from_there_on) {
  const auto graph = read(kGraph);
  ASSERT_TRUE(graph);
  GraphPlayer player(*graph);
  player.seek(3.0);
  player.set_parameter(0, 1.0f);
  player.seek(4.0);
  EXPECT_EQ(player.state_name(player.states().back()), "walk");
  player.seek(2.0);
  EXPECT_EQ(player.parameters()[0], 0.0f) << "the value of that time";
}

TEST_F(graph_motion, goes_on_when_its_file_has_changed) {
  const auto before = read(kGraph, {{1.0, "go", 1.0f}, {5.0, "go", 0.0f}});
  ASSERT_TRUE(before);
  GraphPlayer old(*before);
  old.seek(1.25);
  ASSERT_EQ(old.states().size(), 2u);
  std::string slower = kGraph;
  slower.replace(slower.find("0.5}"), 3, "2.5");
  const auto changed = read(slower, {{1.0, "go", 1.0f}, {5.0, "go", 0.0f}});
  ASSERT_TRUE(changed) << changed.error();
  GraphPlayer now(*changed);
  now.continue_from(old);
  EXPECT_EQ(now.time_s(), 1.25);
  EXPECT_EQ(now.parameters()[0], 1.0f);
  EXPECT_EQ(translation_of(now.world()).y, translation_of(old.world()).y);
  ASSERT_EQ(now.states().size(), 2u);
  EXPECT_EQ(now.states()[1].time_s, old.states()[1].time_s);
  EXPECT_LT(now.states()[1].weight, old.states()[1].weight) << "a quarter of a second of 2.5 s";
  now.seek(3.0);
  EXPECT_EQ(now.states().size(), 2u) << "it still fades";
  now.seek(1.0);
  EXPECT_EQ(now.time_s(), 1.0);
  EXPECT_EQ(now.states().size(), 1u);
}

TEST_F(graph_motion, faults_are_named_with_file_and_place) {
  const auto error = [&](std::string from, const std::string& to, std::vector<GraphSetting> script = {}) {
    std::string text = kGraph;
    text.replace(text.find(from), from.size(), to);
    const auto graph = read(text, std::move(script));
    return graph ? std::string() : graph.error();
  };
  EXPECT_EQ(error("\"clip\": \"wave\"", "\"clip\": \"wink\""),
            file_ + ": /nodes/wave/clip: the model has no clip \"wink\"; it has \"walk\", \"wave\"");
  EXPECT_EQ(error("[\"arm_l\"]", "[\"tail\"]"), file_ + ": /masks/arm/0: the model has no joint \"tail\"");
  EXPECT_THAT(error("\"root\": \"body\"", "\"root\": \"soul\""), HasSubstr(file_ + ": /root"));
  EXPECT_THAT(error("{\"graph\"", "{graph"), HasSubstr(file_));
  EXPECT_EQ(error("stand", "stand", {{0.0, "come", 1.0f}}),
            "--set come: the graph has no such parameter; it has \"go\"");
  std::filesystem::remove(file_);
  EXPECT_EQ(read_graph_for(file_, scene_, {}, {}).error(), file_ + ": is no file");
}

TEST(layer_choice, reads_layers_and_names_what_is_wrong) {
  const auto layer = parse_layer("Wave,weight=0.25,mask=arm_l,mirror,add");
  ASSERT_TRUE(layer);
  EXPECT_EQ(layer->clip, "Wave");
  EXPECT_EQ(layer->mask, "arm_l");
  EXPECT_EQ(layer->weight, 0.25f);
  EXPECT_TRUE(layer->mirrored);
  EXPECT_EQ(layer->use, LayerUse::add_to_rest);
  EXPECT_EQ(parse_layer("1,add-start,weight=-2")->weight, -2.0f);
  for (const char* faulty : {"", ",mirror", "a,weight=x", "a,weight=2", "a,weight=-1", "a,weight=inf", "a,turn", "a,"})
    EXPECT_FALSE(parse_layer(faulty)) << faulty;
  const Scene scene = walker();
  EXPECT_EQ(find_layers({*parse_layer("wave,mask=arm_l")}, scene)->front(),
            (LayerSetting{1, 1.0f, *scene.skeleton.find("arm_l")}));
  EXPECT_THAT(find_layers({*parse_layer("fly")}, scene).error(), HasSubstr("--layer: fly: no such clip"));
  EXPECT_THAT(find_layers({*parse_layer("wave,mask=tail")}, scene).error(), HasSubstr("mask=tail"));
  MotionSettings settings;
  settings.layers = {{1}, {2}, {0, 1.0f, 99}};
  keep_layers_of(scene, settings);
  EXPECT_EQ(settings.layers, std::vector<LayerSetting>{{1}}) << "a reloaded file may have less";
}

TEST(layer_choice, reads_changes_of_parameters) {
  const auto setting = parse_graph_setting("speed=-1.5@2.25");
  ASSERT_TRUE(setting);
  EXPECT_EQ(setting->parameter, "speed");
  EXPECT_EQ(setting->value, -1.5f);
  EXPECT_EQ(setting->time_s, 2.25);
  EXPECT_EQ(parse_graph_setting("a@b=1")->parameter, "a@b");
  for (const char* faulty : {"speed", "=1", "speed=x", "speed=1@", "speed=1@-1", "speed=nan"})
    EXPECT_FALSE(parse_graph_setting(faulty)) << faulty;
}

}  // namespace
}  // namespace sinew::viewer
