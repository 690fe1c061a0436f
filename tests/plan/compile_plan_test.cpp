// SPDX-License-Identifier: MIT
#include "runtime/plan/compile_plan.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "runtime/base/same_bits.h"
#include "runtime/plan/compiled_plan.h"
#include "runtime/plan/frame_hash.h"
#include "runtime/plan/run_plan.h"
#include "runtime/pose/pose.h"
#include "tests/plan/plan_dump.h"
#include "tests/scenes/hand_scenes.h"
#include "tests/scenes/random_scene.h"

namespace sinew::test {
namespace {

TEST(compile_plan, no_frame_waits_for_the_choice_of_an_instruction_set) {
  hwy::GetChosenTarget().DeInit();
  compile_plan(prop_scene(), {});
  EXPECT_TRUE(hwy::GetChosenTarget().IsInitialized());
}

TEST(compile_plan, a_prop_needs_nothing_but_its_place) {
  const Scene scene = prop_scene();
  EXPECT_EQ(dump(compile_plan(lend(scene), {})),
            "- sample [0, 0 B]: no clips: the rest pose is written once\n"
            "- mirror [0, 0 B]: nothing is sampled\n"
            "- blend [0, 0 B]: nothing is sampled\n"
            "- add [0, 0 B]: nothing is sampled\n"
            "- pose_program [0, 0 B]: no pose programs are asked for\n"
            "- interpolate [0, 0 B]: nothing is sampled\n"
            "- correctives [0, 0 B]: the scene has no corrective shapes\n"
            "- properties [0, 0 B]: no clip moves a material, a light, a camera or a flag\n"
            "+ local_to_model [1, 48 B]: joints are asked for; no clip moves any, they are composed once; no scale\n"
            "- palette [0, 0 B]: no mesh instance is skinned\n"
            "- split_palette [0, 0 B]: no primitive is skinned with dual quaternions or about centers of rotation\n"
            "- combinations [0, 0 B]: no vertex blends the matrices of several joints\n"
            "- winding [0, 0 B]: no scale can change its sign: known beforehand\n"
            "- morph [0, 0 B]: no mesh instance has morph targets\n"
            "- skin_linear [0, 0 B]: no mesh instance is skinned\n"
            "- skin_dual_quaternion [0, 0 B]: no mesh instance is skinned\n"
            "- skin_center_of_rotation [0, 0 B]: no mesh instance is skinned\n"
            "- geometry_cache [0, 0 B]: no mesh instance is asked to play from a cache\n"
            "- flat_normals [0, 0 B]: no deformed primitive lacks normals in the file\n"
            "- bounds [0, 0 B]: boxes are not asked for\n");
}

TEST(compile_plan, an_arm_is_sampled_and_skinned) {
  const Scene scene = arm_scene();
  Needs needs;
  needs.in.max_layers = 1;
  EXPECT_EQ(dump(compile_plan(lend(scene), needs)),
            "+ sample [1, 640 B]: 1 clip; the one with most tracks has 1 slerp\n"
            "- mirror [0, 0 B]: no mirrored layers are asked for\n"
            "- blend [0, 0 B]: at most one layer is asked for\n"
            "- add [0, 0 B]: no layers that add are asked for\n"
            "- pose_program [0, 0 B]: no pose programs are asked for\n"
            "- interpolate [0, 0 B]: no frames between updates are asked for\n"
            "- correctives [0, 0 B]: the scene has no corrective shapes\n"
            "- properties [0, 0 B]: no clip moves a material, a light, a camera or a flag\n"
            "+ local_to_model [3, 144 B]: joints are asked for; 2 of 3 are moved by no clip: composed once; no scale\n"
            "+ palette [2, 128 B]: 1 of 1 skin called for by mesh instances\n"
            "- split_palette [0, 0 B]: no primitive is skinned with dual quaternions or about centers of rotation\n"
            "- combinations [0, 0 B]: sharing does not pay in 1 primitive: 1 combination of joints and weights for 2 "
            "vertices\n"
            "- winding [0, 0 B]: no scale can change its sign: known beforehand\n"
            "- morph [0, 0 B]: no mesh instance has morph targets\n"
            "+ skin_linear [4, 96 B]: 1 primitive with joints and weights\n"
            "- skin_dual_quaternion [0, 0 B]: all skinned primitives use another kind of skinning\n"
            "- skin_center_of_rotation [0, 0 B]: all skinned primitives use another kind of skinning\n"
            "- geometry_cache [0, 0 B]: no mesh instance is asked to play from a cache\n"
            "- flat_normals [0, 0 B]: no deformed primitive lacks normals in the file\n"
            "- bounds [0, 0 B]: boxes are not asked for\n");
}

TEST(compile_plan, a_face_is_morphed_and_bounded) {
  const Scene scene = face_scene();
  Needs needs;
  needs.out.joints = false;
  needs.out.bounds = true;
  needs.in.max_layers = 2;
  EXPECT_EQ(
      dump(compile_plan(lend(scene), needs)),
      "+ sample [2, 648 B]: 1 clip; the one with most tracks has 2 linear\n"
      "- mirror [0, 0 B]: no mirrored layers are asked for\n"
      "+ blend [1, 648 B]: up to 2 layers; a single one of full weight skips the stage\n"
      "- add [0, 0 B]: no layers that add are asked for\n"
      "- pose_program [0, 0 B]: no pose programs are asked for\n"
      "- interpolate [0, 0 B]: no frames between updates are asked for\n"
      "- correctives [0, 0 B]: the scene has no corrective shapes\n"
      "- properties [0, 0 B]: no clip moves a material, a light, a camera or a flag\n"
      "+ local_to_model [1, 48 B]: mesh instances hang on joints; no clip moves any, they are composed once; no scale\n"
      "- palette [0, 0 B]: no mesh instance is skinned\n"
      "- split_palette [0, 0 B]: no primitive is skinned with dual quaternions or about centers of rotation\n"
      "- combinations [0, 0 B]: no vertex blends the matrices of several joints\n"
      "- winding [0, 0 B]: no scale can change its sign: known beforehand\n"
      "+ morph [4, 160 B]: 1 primitive with targets that move something; targets of weight 0 cost nothing\n"
      "- skin_linear [0, 0 B]: no mesh instance is skinned\n"
      "- skin_dual_quaternion [0, 0 B]: no mesh instance is skinned\n"
      "- skin_center_of_rotation [0, 0 B]: no mesh instance is skinned\n"
      "- geometry_cache [0, 0 B]: no mesh instance is asked to play from a cache\n"
      "- flat_normals [0, 0 B]: no deformed primitive lacks normals in the file\n"
      "+ bounds [4, 24 B]: boxes are asked for; rigid meshes move the box of their rest pose\n");
}

TEST(compile_plan, dual_quaternions_split_palettes_and_only_theirs) {
  const Scene scene = random_scene(1);
  Needs needs;
  const Plan linear = compile_plan(lend(scene), needs);
  EXPECT_FALSE(stage(linear, "split_palette").runs);
  EXPECT_FALSE(stage(linear, "skin_dual_quaternion").runs);

  needs.skin.kind = Skinning::dual_quaternion;
  const Plan dual = compile_plan(lend(scene), needs);
  EXPECT_EQ(stage(dual, "split_palette").count, stage(dual, "palette").count);
  EXPECT_FALSE(stage(dual, "skin_linear").runs);

  // Instances 0 and 2 are skinned, by skins 0 and 1.
  needs.skin.kind = Skinning::linear;
  needs.skin.per_instance = {Skinning::linear, Skinning::linear, Skinning::dual_quaternion, Skinning::linear};
  const Plan mixed = compile_plan(lend(scene), needs);
  EXPECT_EQ(stage(mixed, "split_palette").count, scene.skins[1].joints.size());
  EXPECT_EQ(stage(mixed, "skin_linear").count + stage(mixed, "skin_dual_quaternion").count,
            stage(linear, "skin_linear").count);
}

TEST(compile_plan, center_of_rotation_skinning_takes_palette_and_split_of_primitives_with_centers) {
  Scene scene = arm_scene();
  Primitive& arm = scene.meshes[0].primitives[0];
  arm.centers_of_rotation = arm.positions;
  const Needs needs{.skin = {.kind = Skinning::center_of_rotation}};
  const Plan plan = compile_plan(lend(scene), needs);
  EXPECT_TRUE(stage(plan, "palette").runs);
  EXPECT_TRUE(stage(plan, "split_palette").runs);
  EXPECT_EQ(stage(plan, "skin_center_of_rotation").reason, "1 primitive with joints and weights");
  EXPECT_EQ(stage(plan, "skin_center_of_rotation").count, 4u);
  EXPECT_FALSE(stage(plan, "skin_linear").runs);
  EXPECT_FALSE(stage(plan, "skin_dual_quaternion").runs);
}

TEST(compile_plan, N21_a_primitive_without_centers_is_skinned_linearly_and_the_plan_says_so) {
  const Scene scene = arm_scene();
  const Plan plan = compile_plan(lend(scene), {.skin = {.kind = Skinning::center_of_rotation}});
  EXPECT_EQ(stage(plan, "skin_center_of_rotation").reason, "1 primitive without centers of rotation: skinned linearly");
  EXPECT_FALSE(stage(plan, "skin_center_of_rotation").runs);
  EXPECT_EQ(stage(plan, "skin_linear").reason,
            "1 primitive with joints and weights; 1 for want of centers of rotation");
  EXPECT_FALSE(stage(plan, "split_palette").runs);
  EXPECT_EQ(compile_plan(lend(scene), {}).frame_bytes(), plan.frame_bytes());
}

TEST(compile_plan, P11_palettes_are_made_only_for_skins_in_use) {
  RandomSceneOptions options;
  options.skins = 5;
  options.instances = 3;  // instances 0 and 2 use skins 0 and 1
  const Scene scene = random_scene(2, options);
  const Plan plan = compile_plan(lend(scene), {});
  EXPECT_EQ(stage(plan, "palette").count, scene.skins[0].joints.size() + scene.skins[1].joints.size());
  EXPECT_EQ(plan.compiled()->palette, (std::vector<bool>{true, true, false, false, false}));
}

TEST(compile_plan, P10_attributes_that_nobody_asks_for_are_left_out) {
  const Scene scene = random_scene(3);
  Needs needs;
  const Plan all = compile_plan(lend(scene), needs);
  needs.out.tangents = false;
  const Plan fewer = compile_plan(lend(scene), needs);
  needs.out.normals = false;
  const Plan positions = compile_plan(lend(scene), needs);
  EXPECT_LT(fewer.frame_bytes(), all.frame_bytes());
  EXPECT_LT(positions.frame_bytes(), fewer.frame_bytes());
  for (const PrimitivePlan& p : positions.primitives())
    EXPECT_FALSE(p.skin.normals || p.skin.tangents || p.morph.normals);
}

TEST(compile_plan, P13_tangents_are_deformed_only_where_a_normal_map_looks_at_them) {
  Scene scene = random_scene(3);
  const auto with_tangents = [&](const Needs& needs = {}) {
    const Plan plan = compile_plan(lend(scene), needs);
    return std::ranges::count_if(plan.primitives(),
                                 [](const PrimitivePlan& p) { return p.skin.tangents || p.morph.tangents; });
  };
  const auto without_material = with_tangents();
  ASSERT_GT(without_material, 0) << "what has no material is the consumer's to light";
  scene.materials.assign(2, {});
  for (Mesh& mesh : scene.meshes)
    for (Primitive& primitive : mesh.primitives) primitive.material = 0;
  EXPECT_EQ(with_tangents(), 0);
  EXPECT_EQ(with_tangents({.out = {.tangents_of_all = true}}), without_material);
  for (Mesh& mesh : scene.meshes)
    for (Primitive& primitive : mesh.primitives) {
      primitive.material = kNone;
      primitive.variant_materials = {{0, 0}};
    }
  EXPECT_EQ(with_tangents(), 0) << "the variants have no normal map";
  for (Mesh& mesh : scene.meshes)
    for (Primitive& primitive : mesh.primitives) {
      primitive.material = 0;
      primitive.variant_materials.clear();
    }
  scene.materials[1].normal_texture.texture = 0;
  EXPECT_EQ(with_tangents(), 0) << "no primitive has that material";
  scene.meshes[0].primitives[0].variant_materials = {{0, 1}};
  EXPECT_GT(with_tangents(), 0) << "a variant has it";
  scene.meshes[0].primitives[0].variant_materials.clear();
  scene.materials[0].normal_texture.texture = 0;
  EXPECT_EQ(with_tangents(), without_material);
}

TEST(compile_plan, P14_boxes_are_made_only_when_asked_for) {
  const Scene scene = random_scene(7);
  Needs needs;
  const Plan without = compile_plan(lend(scene), needs);
  needs.out.bounds = true;
  const Plan with = compile_plan(lend(scene), needs);
  EXPECT_FALSE(stage(without, "bounds").runs);
  EXPECT_TRUE(stage(with, "bounds").runs);
  const ClipLayer layer{0, 0.4};
  FrameBuffer plain(without), boxed(with);
  ASSERT_EQ(run_plan(without, {.layers = {&layer, 1}, .weights = {}, .root = {}}, plain), ErrorCode::ok);
  ASSERT_EQ(run_plan(with, {.layers = {&layer, 1}, .weights = {}, .root = {}}, boxed), ErrorCode::ok);
  EXPECT_EQ(plain.result().work.bounds_vertices, 0u);
  EXPECT_EQ(boxed.result().work.bounds_vertices, stage(with, "bounds").count);
  for (const InstanceResult& instance : plain.result().instances) EXPECT_TRUE(instance.bounds.empty());
  EXPECT_EQ(hash_vertices(plain.result()), hash_vertices(boxed.result()));
}

TEST(compile_plan, P06_one_layer_takes_no_memory_for_more) {
  const Scene scene = random_scene(4);
  Needs one, four;
  one.in.max_layers = 1;
  four.in.max_layers = 4;
  const std::size_t layer_bytes = sizeof(float) * PoseSpan::floats_for(scene.skeleton.joint_count());
  const Plan small = compile_plan(lend(scene), one), large = compile_plan(lend(scene), four);
  EXPECT_GE(large.frame_bytes(), small.frame_bytes() + 3 * layer_bytes);
  EXPECT_LT(small.compiled()->layout.pose_program.count, layer_bytes);
}

TEST(compile_plan, frames_of_one_clip_touch_only_the_front_of_their_memory_before_vertices) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const Scene scene = random_scene(seed);
    Needs needs;
    needs.out.positions = needs.out.normals = needs.out.tangents = false;
    needs.out.palettes = needs.out.weights = needs.out.properties = true;
    const Plan plan = compile_plan(lend(scene), needs);
    const std::size_t front_bytes = plan.compiled()->layout.front_bytes;
    ASSERT_LT(front_bytes, plan.frame_bytes());
    struct alignas(64) Line {
      std::byte bytes[64];
    };
    std::vector<Line> block(plan.frame_bytes() / sizeof(Line));
    FrameBuffer frame(plan, std::as_writable_bytes(std::span(block)));
    const auto behind = std::as_bytes(std::span(block)).subspan(front_bytes);
    const std::vector<std::byte> before(behind.begin(), behind.end());
    for (int f = 0; f < 3; ++f) {
      const ClipLayer layer{0, 0.3 * f, 1.0f};
      ASSERT_EQ(run_plan(plan, {.layers = {&layer, 1}, .weights = {}, .root = {}}, frame), ErrorCode::ok);
      EXPECT_TRUE(std::equal(behind.begin(), behind.end(), before.begin())) << "seed " << seed << ", frame " << f;
    }
    EXPECT_GT(frame.result().work.joints_composed, 0u);
  }
}

TEST(compile_plan, P05_tracks_are_told_by_the_way_they_take_between_keys) {
  Scene scene = arm_scene();
  Animation& bend = scene.animations[0];
  ASSERT_EQ(bend.bones.size(), 1u);
  BoneAnimation& lower = bend.bones[0];
  const auto reason = [&] {
    finish_scene(scene);
    return stage(compile_plan(lend(scene), {}), "sample").reason;
  };
  lower.rotation.interpolation = Interpolation::step;
  EXPECT_EQ(reason(), "1 clip; the one with most tracks has 1 step");
  lower.rotation.interpolation = Interpolation::squad;
  EXPECT_EQ(reason(), "1 clip; the one with most tracks has 1 squad");
  lower.translation = {.interpolation = Interpolation::linear,
                       .times_s = {0.0f, 1.0f},
                       .values = {glm::vec3(0, 1, 0), glm::vec3(0, 2, 0)}};
  EXPECT_EQ(reason(), "1 clip; the one with most tracks has 1 linear, 1 squad");
  bend.bones.clear();
  EXPECT_EQ(reason(), "1 clip; the one with most tracks has none that moves");
}

TEST(compile_plan, nothing_asked_for_leaves_only_morph_weights) {
  Needs needs;
  needs.out.joints = needs.out.local_pose = false;
  needs.out.positions = needs.out.normals = needs.out.tangents = false;
  const Scene face = face_scene(), arm = arm_scene();
  EXPECT_TRUE(compile_plan(lend(face), needs).runs(Stage::sample));
  const Plan plan = compile_plan(lend(arm), needs);
  for (const PlanStage& stage : plan.stages()) EXPECT_FALSE(stage.runs) << stage.stage;
  EXPECT_EQ(stage(plan, "sample").reason, "no joints, local pose, vertices or morph weights are asked for");
  EXPECT_EQ(stage(plan, "skin_linear").reason, "no vertices are asked for");
}

TEST(compile_plan, morphing_that_is_left_out_says_whether_scene_or_needs_call_for_none) {
  const auto reason = [](const Scene& scene, const Needs& needs) {
    return stage(compile_plan(lend(scene), needs), "morph").reason;
  };
  Scene turning = face_scene();
  for (MorphTarget& target : turning.meshes[0].primitives[0].morphs.targets)
    target = {.positions = {}, .normals = target.normals};
  Needs joints, places;
  joints.out.positions = joints.out.normals = joints.out.tangents = false;
  places.out.normals = places.out.tangents = false;
  EXPECT_EQ(reason(arm_scene(), {}), "no mesh instance has morph targets");
  EXPECT_EQ(reason(face_scene(), joints), "no vertices are asked for");
  EXPECT_EQ(reason(turning, places), "no target moves an attribute that is asked for");
  EXPECT_EQ(reason(turning, {}), "1 primitive with targets that move something; targets of weight 0 cost nothing");
}

TEST(compile_plan, every_stage_says_why) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    RandomSceneOptions options;
    options.skins = seed % 3;
    options.targets = seed % 2 * 2;
    options.clips = seed % 2;
    options.flat_normals = seed % 5 == 0;
    const Scene scene = random_scene(seed, options);
    Needs needs;
    needs.out.bounds = seed % 2 == 0;
    needs.out.normals = seed % 4 != 0;
    const Plan plan = compile_plan(lend(scene), needs);
    const std::vector<PlanStage> stages = plan.stages();
    ASSERT_EQ(stages.size(), kStageCount);
    for (std::size_t s = 0; s < stages.size(); ++s) {
      EXPECT_FALSE(stages[s].reason.empty()) << stages[s].stage;
      EXPECT_EQ(stages[s].runs, stages[s].bytes > 0) << stages[s].stage;
      EXPECT_EQ(stages[s].runs, plan.runs(static_cast<Stage>(s))) << stages[s].stage;
    }
  }
}

TEST(compile_plan, places_in_frame_memory_do_not_overlap_and_are_aligned) {
  RandomSceneOptions options;
  options.flat_normals = true;
  const Scene scene = random_scene(5, options);
  Needs needs;
  needs.in.additive = true;
  const Plan plan = compile_plan(lend(scene), needs);
  const CompiledPlan& compiled = *plan.compiled();
  const FrameLayout& layout = compiled.layout;
  std::vector<std::pair<std::size_t, std::size_t>> places;
  const auto take = [&]<class T>(const Block<T>& block, std::size_t count) {
    EXPECT_EQ(block.count, count);
    if (count > 0) places.emplace_back(block.offset, block.offset + count * sizeof(T));
  };
  const std::size_t pose_floats = PoseSpan::floats_for(scene.skeleton.joint_count()), weights = scene.weight_count();
  take(layout.rest_pose.planes, pose_floats);
  take(layout.pose.pose.planes, pose_floats);
  take(layout.pose_program, layout.pose_program.count);
  EXPECT_GE(layout.pose_program.count, 3 * sizeof(float) * (pose_floats + weights));
  take(layout.pose.weights, weights);
  take(layout.model, scene.skeleton.joint_count());
  for (std::size_t s = 0; s < scene.skins.size(); ++s)
    take(layout.palettes[s], compiled.palette[s] ? matrix_count(compiled, s) : 0);
  for (std::size_t i = 0; i < compiled.primitives.size(); ++i) {
    const PrimitivePlan& p = compiled.primitives[i];
    const VertexBlocks& blocks = layout.primitives[i];
    const std::size_t count = primitive_of(plan, p).vertex_count();
    take(blocks.positions, p.morph.positions || p.skin.positions ? count : 0);
    take(blocks.normals, p.morph.normals || p.skin.normals || p.flat_normals ? count : 0);
    take(blocks.tangents, p.morph.tangents || p.skin.tangents ? count : 0);
    take(blocks.colors, p.morph_colors ? count : 0);
  }
  std::sort(places.begin(), places.end());
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_EQ(places[i].first % 64, 0u);
    EXPECT_LE(places[i].second, i + 1 < places.size() ? places[i + 1].first : plan.frame_bytes());
  }
}

/// The scene with all other instances hidden. Their skins keep their indices.
Scene only_instance(Scene scene, std::size_t kept) {
  const MeshInstance instance = scene.instances[kept];
  const Skin skin = scene.skins[instance.skin];
  scene.instances = {instance};
  scene.skins = {skin};
  scene.instances[0].skin = 0;
  for (Animation& animation : scene.animations) {
    std::erase_if(animation.weights, [&](const WeightAnimation& w) { return w.instance != kept; });
    for (WeightAnimation& w : animation.weights) w.instance = 0;
  }
  scene.clips.clear();
  finish_scene(scene);
  return scene;
}

TEST(compile_plan, each_skin_is_bent_as_it_is_alone_whatever_kind_the_others_are_of) {
  for (std::uint32_t seed = 0; seed < 6; ++seed) {
    RandomSceneOptions options;
    options.skins = 3;
    options.instances = 6;
    options.centers = true;
    const Scene scene = random_scene(seed, options);
    Needs needs;
    for (std::size_t i = 0; i < scene.instances.size(); ++i)
      needs.skin.per_instance.push_back(i % 4 == 1 ? Skinning::dual_quaternion : Skinning::linear);
    const Plan plan = compile_plan(lend(scene), needs);
    FrameBuffer frame(plan);
    const ClipLayer layer{0, 0.3 + 0.1 * seed};
    const Affine turned = affine_from_transform(Transform{{1, 2, 3}, quat_xyzw(0.0f, 1.0f, 0.0f, 0.0f), {1, 1, 1}});
    const FrameInput input{.layers = {&layer, 1}, .weights = {}, .root = turned};
    ASSERT_EQ(run_plan(plan, input, frame), ErrorCode::ok);
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
      if (scene.instances[i].skin == kNone) continue;
      const Scene alone = only_instance(scene, i);
      Needs own;
      own.skin.kind = needs.skin.per_instance[i];
      const Plan own_plan = compile_plan(lend(alone), own);
      FrameBuffer own_frame(own_plan);
      ASSERT_EQ(run_plan(own_plan, input, own_frame), ErrorCode::ok);
      const auto mine = own_frame.result().primitives;
      const std::uint32_t first = frame.result().instances[i].first_primitive;
      for (std::size_t p = 0; p < mine.size(); ++p) {
        EXPECT_TRUE(same_bits<glm::vec3>(mine[p].positions, frame.result().primitives[first + p].positions))
            << "seed " << seed << " instance " << i;
        EXPECT_TRUE(same_bits<glm::vec3>(mine[p].normals, frame.result().primitives[first + p].normals));
      }
    }
  }
}

}  // namespace
}  // namespace sinew::test
