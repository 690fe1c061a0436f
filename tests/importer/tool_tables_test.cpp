// SPDX-License-Identifier: MIT
// Tables and documents of the tool, word for word, of contents that are made by hand.
#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "importer/tool/certificate_table.h"
#include "importer/tool/info/memory_kinds.h"
#include "importer/tool/info/node_tree.h"
#include "importer/tool/left_out_joints.h"
#include "importer/tool/length_text.h"
#include "importer/tool/messages.h"
#include "importer/tool/vrm/vrm_info.h"
#include "tests/importer/tool_json.h"
#include "tests/scenes/hand_scenes.h"
#include "tests/support/json.h"
#include "tests/support/tiny_assets.h"

namespace sinew::test {
namespace {

TEST(tool_words, sizes_change_their_unit_at_ten_thousand) {
  EXPECT_EQ(tool::size_text(0), "0 B");
  EXPECT_EQ(tool::size_text(9'999), "9999 B");
  EXPECT_EQ(tool::size_text(10'000), "10.0 kB");
  EXPECT_EQ(tool::size_text(12'345), "12.3 kB");
  EXPECT_EQ(tool::size_text(9'999'900), "9999.9 kB");
  EXPECT_EQ(tool::size_text(10'000'000), "10.0 MB");
  EXPECT_EQ(tool::size_text(123'456'789), "123.5 MB");
}

TEST(tool_words, lengths_have_three_digits_in_a_unit_that_fits) {
  EXPECT_EQ(tool::length_text(1.0), "1 m");
  EXPECT_EQ(tool::length_text(12.345), "12.3 m");
  EXPECT_EQ(tool::length_text(0.999), "999 mm");
  EXPECT_EQ(tool::length_text(0.0123456), "12.3 mm");
  EXPECT_EQ(tool::length_text(1e-4), "0.1 mm");
  EXPECT_EQ(tool::length_text(0.999e-4), "99.9 um");
  EXPECT_EQ(tool::length_text(1.5e-9), "0.0015 um");
}

TEST(tool_words, one_thing_is_not_many) {
  EXPECT_EQ(tool::counted(0, "clip"), "0 clips");
  EXPECT_EQ(tool::counted(1, "clip"), "1 clip");
  EXPECT_EQ(tool::counted(2, "clip"), "2 clips");
  EXPECT_EQ(tool::counted(1, "mesh"), "1 mesh");
  EXPECT_EQ(tool::counted(2, "mesh"), "2 meshes");
}

TEST(tool_tables, a_node_is_animated_by_whatever_moves_or_hides_it) {
  Scene scene = arm_scene();
  scene.skeleton.node_of_joint = {2, 0, 1};
  scene.skeleton.joint_of_node = {1, 2, 0};
  const auto animated_by = [&](const auto& add) {
    Animation animation;
    add(animation);
    return tool::animated_nodes(scene, animation);
  };
  using Nodes = std::set<std::uint32_t>;
  BoneAnimation bone;
  bone.joint = 2;
  EXPECT_EQ(animated_by([&](Animation& a) { a.bones = {bone}; }), Nodes{}) << "no track has keys";
  const Vec3Track moved{Interpolation::linear, {0.0f}, {{1, 0, 0}}};
  for (Vec3Track BoneAnimation::*track : {&BoneAnimation::translation, &BoneAnimation::scale}) {
    BoneAnimation with = bone;
    with.*track = moved;
    EXPECT_EQ(animated_by([&](Animation& a) { a.bones = {with}; }), Nodes{1});
  }
  bone.rotation = {Interpolation::linear, {0.0f}, {glm::quat(1, 0, 0, 0)}};
  EXPECT_EQ(animated_by([&](Animation& a) { a.bones = {bone}; }), Nodes{1});
  EXPECT_EQ(animated_by([&](Animation& a) { a.weights.push_back({}); }), Nodes{0}) << "the instance's";
  EXPECT_EQ(animated_by([&](Animation& a) {
              a.properties.push_back({{PropertyKind::node_visible, 0}, {}});
            }),
            Nodes{2});
  EXPECT_EQ(animated_by([&](Animation& a) { a.properties.push_back({{PropertyKind::base_color, 0}, {}}); }), Nodes{});
}

TEST(tool_tables, memory_has_every_kind_that_takes_some) {
  const MemoryBytes all{.skeletons = 1,
                        .animations = 2,
                        .clip_keys = 3,
                        .clip_tables = 4,
                        .skins = 5,
                        .vertices = 6,
                        .morphs = 7,
                        .images = 8,
                        .others = 9,
                        .plans = 10,
                        .frames = 20'000};
  const auto json = tool::memory_json(all);
  EXPECT_EQ(Json(parsed(json)), (Json{{"total", 20'055},
                                      {"skeletons", 1},
                                      {"animations", 2},
                                      {"clip_keys", 3},
                                      {"clip_tables", 4},
                                      {"skins", 5},
                                      {"vertices", 6},
                                      {"morphs", 7},
                                      {"images", 8},
                                      {"others", 9},
                                      {"plans", 10},
                                      {"frames", 20'000}}));
  EXPECT_EQ(tool::memory_text(json),
            "memory: 20.1 kB (skeletons 1 B, animations 2 B, clip keys 3 B, clip tables 4 B, skins 5 B, vertices 6 B, "
            "morphs 7 B, images 8 B, others 9 B, plans 10 B, frames 20.0 kB)\n");
  EXPECT_EQ(Json(parsed(tool::memory_json({}))), (Json{{"total", 0}}));
}

/// A clip of one joint that takes as long as said.
Clip clip_named(const std::string& name, float seconds) {
  BoneAnimation bone;
  bone.joint = 0;
  bone.translation = {Interpolation::linear, {0.0f, seconds}, {{0, 0, 0}, {1, 0, 0}}};
  if (seconds == 0.0f) bone.translation = {Interpolation::linear, {0.0f}, {{1, 0, 0}}};
  Animation animation = animation_of({bone});
  animation.name = name;
  return clip_of(animation, skeleton_of({kNone}));
}

TEST(tool_tables, certificates) {
  const double none = std::numeric_limits<double>::infinity();
  const auto with = [](const Clip& clip, ClipCertificate c) {
    c.animated_joints = 3;
    c.source_keys = 40;
    c.source_bytes = 5000;
    return with_certificate(clip, c);
  };
  const std::vector<Clip> clips = {
      with(clip_named("kept", 2.0f), {.asked_m = 1e-3,
                                      .measured_m = 1e-3,
                                      .worst_time_s = 1.23456,
                                      .worst_joint = 0,
                                      .kept_keys = 12,
                                      .bytes = 900}),
      clip_named("not measured", 1.0f),
      with(clip_named("", 0.5f),
           {.asked_m = 0.0, .measured_m = 2e-6, .worst_time_s = 0.25, .worst_joint = 1, .kept_keys = 7, .bytes = 80}),
      with(clip_named("as it is", 0.0f),
           {.asked_m = none, .measured_m = 0.0, .worst_joint = kNone, .kept_keys = 1, .bytes = 10}),
      with(clip_named("beyond the names", 1.0f),
           {.asked_m = 2.0, .measured_m = 0.5, .worst_joint = 2, .kept_keys = 1, .bytes = 10})};
  const std::vector<std::string> names = {"hip", ""};
  EXPECT_EQ(
      tool::certificate_table(clips, names),
      R"(  #  clip                asked  measured  kept  worst at  worst time  keys  of  bytes  of all keys  bytes/joint/s
  0  "kept"              1 mm       1 mm  yes   "hip"        1.235 s    12  40    900         5000          150.0
  2                      0          2 um  NO    joint 1       0.25 s     7  40     80         5000           53.3
  3  "as it is"          -             0  -                      0 s     1  40     10         5000
  4  "beyond the names"  2 m      500 mm  yes   joint 2          0 s     1  40     10         5000            3.3
)");
  EXPECT_EQ(tool::certificate_table({}, {}), "");
}

/// Joints 0 to 6: 0 -> 1, 2; 1 -> 3, 4; 3 -> 5; 4 -> 6. Left out are 2, 3, 4, 5, 6.
TEST(tool_tables, joints_that_are_left_out) {
  Scene scene = prop_scene();
  scene.skeleton = skeleton_of({kNone, 0, 0, 1, 1, 3, 4});
  scene.skeleton.names[4].clear();
  scene.skeleton.node_of_joint = {10, 11, 12, 13, 14, 15, 16};
  CompiledSkeletonLod lod;
  lod.detail.kept = {true, true, false, false, false, false, false};
  lod.tolerance_m = 0.01;
  lod.measured_m = 0.0025;
  lod.left_out = 5;
  EXPECT_EQ(tool::left_out_text(scene, lod),
            "joints left out within 10 mm: 5 of 7; they move vertices by 2.5 mm at most\n"
            "  joint2 on joint0\n"
            "  joint3 and 1 below on joint1\n"
            "  node 14 and 1 below on joint1\n");
  const auto entry = [](const char* joint, int node, const char* follows) {
    return Json{{"joint", joint}, {"node", node}, {"follows", follows}};
  };
  EXPECT_EQ(Json(parsed(tool::left_out_json(scene, lod))),
            (Json{{"asked", 0.01},
                  {"measured", 0.0025},
                  {"joints", 7},
                  {"left_out",
                   {entry("joint2", 12, "joint0"), entry("joint3", 13, "joint1"), entry("node 14", 14, "joint1"),
                    entry("joint5", 15, "joint1"), entry("joint6", 16, "joint1")}}}));
  EXPECT_EQ(
      tool::lod_lines(std::vector{lod, CompiledSkeletonLod{.tolerance_m = 1.0, .left_out = 1, .measured_m = 0.5}}, 7),
      "skeleton LOD within 10 mm: 5 of 7 joints left out, measured 2.5 mm\n"
      "skeleton LOD within 1 m: 1 of 7 joints left out, measured 500 mm\n");
  EXPECT_EQ(tool::left_out_text(scene, {.detail = {}, .tolerance_m = 0.5}), "joints left out within 500 mm: 0 of 7\n");
}

VrmCharacter character() {
  VrmCharacter vrm;
  vrm.version = "1.0";
  vrm.name = "Ann";
  vrm.authors = "Bea, Cid";
  vrm.bones = {{"hips", 0}, {"head", 2}};
  vrm.expressions = {{"happy",
                      true,
                      true,
                      {{.instance = 0, .target = 1, .weight = 0.5f}, {.instance = 0, .target = 0, .weight = 1.0f}}},
                     {"own", false, false, {{.instance = 0}}}};
  vrm.look_at.kind = VrmLookAt::Kind::expressions;
  vrm.colliders = {{.kind = VrmCollider::Kind::sphere, .joint = 0, .radius_m = 0.25f},
                   {.kind = VrmCollider::Kind::capsule, .joint = 1, .radius_m = 0.5f},
                   {.kind = VrmCollider::Kind::plane, .joint = kNone}};
  vrm.springs = {{.name = "hair", .joints = {{.joint = 1}, {.joint = 2}}, .colliders = {0, 2}},
                 {.name = "tail", .joints = {{.joint = 0}}}};
  vrm.constraints = {{.kind = VrmConstraint::Kind::roll, .joint = 1, .source = 0, .weight = 0.5f},
                     {.kind = VrmConstraint::Kind::aim, .joint = 2, .source = 1},
                     {.kind = VrmConstraint::Kind::rotation, .joint = 0, .source = kNone}};
  return vrm;
}

TEST(tool_tables, characters_in_vrm) {
  Scene scene = arm_scene();
  scene.skeleton.node_of_joint = {7, 8, 9};
  const auto json = tool::vrm_json(character(), scene);
  const auto morph = [](int target, double weight) {
    return Json{{"node", 8}, {"target", target}, {"weight", weight}};
  };
  const auto constraint = [](int node, Json source, const char* kind, double weight) {
    return Json{{"node", node}, {"source", source}, {"kind", kind}, {"weight", weight}};
  };
  EXPECT_EQ(
      Json(parsed(json)),
      (Json{{"version", "1.0"},
            {"name", "Ann"},
            {"authors", "Bea, Cid"},
            {"animation", false},
            {"look_at", "expressions"},
            {"bones", {{"hips", 7}, {"head", 9}}},
            {"expressions",
             {{{"name", "happy"}, {"preset", true}, {"binary", true}, {"morphs", {morph(1, 0.5), morph(0, 1.0)}}},
              {{"name", "own"}, {"preset", false}, {"binary", false}, {"morphs", Json::array({morph(0, 1.0)})}}}},
            {"colliders",
             {{{"node", 7}, {"shape", "sphere"}, {"radius_m", 0.25}},
              {{"node", 8}, {"shape", "capsule"}, {"radius_m", 0.5}},
              {{"node", nullptr}, {"shape", "plane"}, {"radius_m", 0.0}}}},
            {"springs",
             {{{"name", "hair"}, {"nodes", {8, 9}}, {"colliders", 2}},
              {{"name", "tail"}, {"nodes", Json::array({7})}, {"colliders", 0}}}},
            {"constraints",
             {constraint(8, 7, "roll", 0.5), constraint(9, 8, "aim", 1.0), constraint(7, nullptr, "rotation", 1.0)}}}));
  EXPECT_EQ(tool::vrm_text(json),
            "VRM 1.0: 2 humanoid bones, \"Ann\" by \"Bea, Cid\", looks with expressions\n"
            "  expressions: \"happy\" (2 morphs) \"own\" (1 morph)\n"
            "  springs: 2 with 3 joints, 3 colliders\n"
            "  constraint: node 8 follows node 7 (roll, weight 0.5)\n"
            "  constraint: node 9 follows node 8 (aim, weight 1.0)\n"
            "  constraint: node 7 follows node null (rotation, weight 1.0)\n");
}

TEST(tool_tables, clips_in_vrm) {
  VrmCharacter vrm;
  vrm.version = "0.0";
  vrm.is_animation = true;
  vrm.look_at.kind = VrmLookAt::Kind::bones;
  EXPECT_EQ(tool::vrm_text(tool::vrm_json(vrm, arm_scene())),
            "VRM 0.0 animation: 0 humanoid bones, looks with bones\n");
  vrm.look_at.kind = VrmLookAt::Kind::none;
  vrm.is_animation = false;
  EXPECT_EQ(tool::vrm_text(tool::vrm_json(vrm, arm_scene())), "VRM 0.0: 0 humanoid bones\n");
}

}  // namespace
}  // namespace sinew::test
