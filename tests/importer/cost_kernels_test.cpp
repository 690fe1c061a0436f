// SPDX-License-Identifier: MIT
// The building blocks of `sinew cost`: its kernels, the skin probe, the limb, medians and Pareto fronts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "importer/tool/cost/fewer_influences.h"
#include "importer/tool/cost/instruction_sets.h"
#include "importer/tool/cost/limb.h"
#include "importer/tool/cost/measure.h"
#include "importer/tool/cost/rotation/approximate_slerp.h"
#include "importer/tool/cost/rotation/rotation_lanes.h"
#include "importer/tool/cost/rotation/rotation_tracks.h"
#include "importer/tool/cost/skin_probe.h"
#include "importer/tool/cost/skinned_part.h"
#include "importer/tool/cost/subject.h"
#include "importer/tool/cost/words.h"
#include "runtime/animation/track_sample.h"
#include "runtime/pose/pose_memory.h"
#include "tests/reference/sampling.h"
#include "tests/reference/skinning.h"
#include "tests/scenes/hand_scenes.h"
#include "tests/support/fixed_random.h"
#include "tests/support/tiny_assets.h"

namespace sinew::test {
namespace {

using testing::ElementsAre;

constexpr std::uint32_t kJoints = 37;  // not a multiple of any vector length

/// Every joint turns through four keys. Neighbouring keys are up to 170 degrees apart, and either sign of a quaternion
/// occurs.
Animation turning(std::uint64_t seed) {
  FixedRandom random(seed);
  Animation out;
  out.duration_s = 3.0;
  for (std::uint32_t j = 0; j < kJoints; ++j) {
    BoneAnimation& bone = out.bones.emplace_back();
    bone.joint = j;
    bone.rotation.times_s = {0.0f, 1.0f, 1.5f, 3.0f};
    glm::quat q = random.rotation_by(random.in(-3, 3));
    for (int k = 0; k < 4; ++k) {
      bone.rotation.values.push_back(random.below(2) == 0 ? q : -q);
      q = normalised(q * random.rotation_by(random.in(-2.9, 2.9)));
    }
  }
  return out;
}

double angle_rad(const glm::quat& found, const Quat<double>& truth) {
  return rotation_angle_between(normalised(quat_cast<double>(found)), normalised(truth));
}

TEST(crooked_pose, turns_each_joint_with_a_parent_by_30_degrees_about_its_axis) {
  const Skeleton skeleton = chain_skeleton(5);
  const cost::LocalPose pose = cost::crooked_pose(skeleton), rest = cost::rest_pose(skeleton);
  for (std::size_t j = 0; j < pose.size(); ++j) {
    const auto turn = glm::inverse(rest[j].rotation) * pose[j].rotation;
    const bool is_root = skeleton.parents[j] == kNone;
    EXPECT_NEAR(2.0 * std::acos(std::min(1.0, std::abs(turn.w))), is_root ? 0.0 : 0.52359877559829887, 1e-7) << j;
    const double along[] = {turn.x, turn.y, turn.z};
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(along[axis], is_root || axis != j % 3 ? 0.0 : 0.25881904510252074, 1e-12) << j << ' ' << axis;
  }
}

TEST(cost_rotation_lanes, agree_with_their_definitions_in_double_on_every_instruction_set) {
  const Animation animation = turning(5);
  const Skeleton skeleton = chain_skeleton(kJoints);
  const Clip clip = compile_clip(animation, skeleton, {}, {}, {});
  using Definition = Quat<double> (*)(const Quat<double>&, const Quat<double>&, double);
  const std::pair<cost::ArcRule, Definition> rules[] = {
      {cost::ArcRule::nlerp, nlerp_short_arc<double>},
      {cost::ArcRule::corrected_nlerp, cost::corrected_nlerp<double>},
      {cost::ArcRule::polynomial_slerp, cost::polynomial_slerp<double>}};
  PoseMemory memory(kJoints);
  for (const cost::InstructionSet& set : cost::instruction_sets()) {
    cost::allow_only(set);
    for (const auto& [rule, definition] : rules)
      for (const double time_s : {0.0, 0.21, 0.5, 0.999, 1.2, 1.5, 2.9, 3.0}) {
        cost::sample_rotations(clip, time_s, rule, memory.span());
        for (const BoneAnimation& bone : animation.bones) {
          const KeyPosition at = locate_key(bone.rotation.times_s, time_s);
          const Quat<double> begin = quat_cast<double>(bone.rotation.values[at.key]);
          const Quat<double> truth =
              at.on_key ? begin : definition(begin, quat_cast<double>(bone.rotation.values[at.key + 1]), at.fraction);
          EXPECT_LT(angle_rad(memory.span().get(bone.joint).rotation, truth), 1e-6)
              << set.name << " rule " << static_cast<int>(rule) << " at " << time_s;
        }
      }
  }
  cost::allow_all_instruction_sets();
}

TEST(cost_rotation_tracks, walking_in_steps_shows_the_frames_of_slerp) {
  for (const BoneAnimation& bone : turning(8).bones) {
    std::vector<glm::quat> frames(181);
    cost::walk_track(bone.rotation, 60.0, frames);
    for (std::size_t f = 0; f < frames.size(); ++f)
      EXPECT_LT(
          angle_rad(frames[f], reference::quat_of(reference::sample(bone.rotation, static_cast<double>(f) / 60.0))),
          2e-6)
          << f;
  }
}

TEST(cost_rotation_tracks, keep_keys_whatever_goes_between_them) {
  const Animation animation = turning(3);
  for (const Interpolation interpolation :
       {Interpolation::step, Interpolation::linear, Interpolation::squad, Interpolation::cubic_spline}) {
    const Animation turned = cost::rotations_only(animation, interpolation);
    ASSERT_EQ(turned.bones.size(), animation.bones.size());
    for (std::size_t b = 0; b < turned.bones.size(); ++b)
      for (const float time_s : {0.0f, 1.0f, 1.5f, 3.0f})
        EXPECT_LT(angle_rad(turned.bones[b].interpolate<float>(static_cast<double>(time_s)).rotation,
                            animation.bones[b].interpolate<double>(static_cast<double>(time_s)).rotation),
                  1e-6);
  }
}

TEST(cost_rotation_tracks, leave_out_what_never_turns) {
  Animation animation = turning(1);
  animation.bones[3].rotation.values.assign(4, animation.bones[3].rotation.values[0]);
  animation.bones[4].rotation.interpolation = Interpolation::step;
  EXPECT_EQ(cost::rotations_only(animation, Interpolation::linear).bones.size(), kJoints - 2u);
}

TEST(cost_skin_probe, finds_the_distance_of_the_farthest_vertex) {
  const Scene arm = arm_scene();  // vertex 1 is one metre above the joint that turns
  const cost::SkinProbe probe(arm, 1000);
  ASSERT_EQ(probe.point_count(), 4u);
  const auto pose = [&](double time_s) {
    return cost::model_pose(arm.skeleton, cost::true_local_pose(arm.skeleton, arm.animations[0], time_s));
  };
  EXPECT_NEAR(probe.distance_m(pose(0.0), pose(1.0)), std::sqrt(2.0), 1e-6);
  EXPECT_EQ(probe.distance_m(pose(0.3), pose(0.3)), 0.0);
}

TEST(cost_skin_probe, shares_a_vertex_between_its_joints_by_weight) {
  Scene arm = arm_scene();
  arm.meshes[0].primitives[0].positions[1] = {
      0, 1, 0};  // on the turning joint: the half-weighted vertices, 0.25 m away, move most
  const cost::SkinProbe probe(arm, 1000);
  const auto pose = [&](double time_s) {
    return cost::model_pose(arm.skeleton, cost::true_local_pose(arm.skeleton, arm.animations[0], time_s));
  };
  EXPECT_NEAR(probe.distance_m(pose(0.0), pose(1.0)), 0.5 * 0.25 * std::sqrt(2.0), 1e-6);
}

TEST(cost_skin_probe, a_mesh_without_a_skin_goes_with_its_joint) {
  Scene arm = arm_scene();
  arm.instances[0].skin = kNone;
  arm.instances[0].joint = 2;  // joint 2 turns; vertex 1 lies two metres from it
  const cost::SkinProbe probe(arm, 1000);
  const auto pose = [&](double time_s) {
    return cost::model_pose(arm.skeleton, cost::true_local_pose(arm.skeleton, arm.animations[0], time_s));
  };
  EXPECT_NEAR(probe.distance_m(pose(0.0), pose(1.0)), 2.0 * std::sqrt(2.0), 1e-6);
}

TEST(cost_true_pose, a_joint_with_a_matrix_of_its_own_has_that_one) {
  Scene arm = arm_scene();
  Affine sheared = affine_from(glm::mat3(1.0f), {7, 8, 9});
  sheared.row[0].y = 0.5f;
  arm.skeleton.fixed_matrices = {sheared};
  arm.skeleton.fixed_matrix_of[0] = 0;
  const auto model = cost::model_pose(arm.skeleton, cost::rest_pose(arm.skeleton));
  EXPECT_EQ(model[0], affine_cast<double>(sheared));
  EXPECT_EQ(translation_of(model[2]), Vec3<double>(7.5, 9, 9)) << "and what hangs on it goes along";
}

TEST(cost_subject, the_busiest_clip_moves_most_joints_however_long_it_lasts) {
  Scene arm = arm_scene();
  Animation busy = arm.animations[0];
  busy.duration_s = 0.25;
  busy.bones.push_back(busy.bones[0]);
  arm.animations = {arm.animations[0], busy, busy, arm.animations[0]};
  EXPECT_EQ(cost::busiest_clip(arm), 1u) << "the first of two";
  arm.animations.clear();
  EXPECT_EQ(cost::busiest_clip(arm), kNone);
}

TEST(cost_skinned_part, is_the_primitive_with_most_vertices_wherever_it_stands) {
  for (const bool larger_last : {false, true}) {
    Scene arm = arm_scene();
    Primitive small = arm.meshes[0].primitives[0];
    small.positions.resize(2);
    small.normals.resize(2);
    small.indices = {0, 1, 1};
    small.influences = {{{0, 2, 1, 0}}, {0, 1}, {1, 1}};
    auto& primitives = arm.meshes[0].primitives;
    primitives.insert(larger_last ? primitives.begin() : primitives.end(), small);
    const cost::Subject subject(arm, kNone, cost::Effort::quick());
    EXPECT_EQ(cost::skinned_part(subject)->vertex_count(), 4u) << larger_last;
  }
}

TEST(cost_skin_probe, looks_around_the_joints_of_a_scene_without_vertices) {
  Scene bones = arm_scene();
  bones.instances.clear();
  const cost::SkinProbe probe(bones, 1000);
  EXPECT_FALSE(probe.has_vertices());
  EXPECT_EQ(probe.point_count(), 3 * bones.skeleton.joint_count());
}

TEST(cost_skin_probe, looks_a_twentieth_of_the_skeletons_size_away_wherever_it_stands) {
  for (const float height : {2.0f, 0.0f}) {  // joints at one place have no size
    Scene bones;
    bones.skeleton.parents = {kNone, 0};
    bones.skeleton.rest.resize(2);
    bones.skeleton.fixed_matrix_of = {kNone, kNone};
    bones.skeleton.rest[0].translation = {10.0f, -7.0f, 3.0f};
    bones.skeleton.rest[1].translation = {0.0f, height, 0.0f};
    const auto pose = cost::model_pose(bones.skeleton, cost::rest_pose(bones.skeleton));
    auto turned = pose;  // joint 1 makes half a turn about x: points on y and z go to its other side
    for (const int row : {1, 2})
      for (const int column : {1, 2}) turned[1].row[row][column] *= -1.0;
    EXPECT_NEAR(cost::SkinProbe(bones, 1000).distance_m(pose, turned), height > 0.0f ? 0.2 : 0.06, 1e-12);
  }
}

TEST(cost_plain_skinning, is_the_reference_in_double) {
  const cost::Limb limb;
  cost::PlainVertices<double> found(limb.primitive.vertex_count());
  cost::skin_plainly<double>(limb.primitive.influences, limb.bent.exact,
                             {limb.primitive.positions, limb.primitive.normals, {}}, NormalRule::cofactor, found);
  for (const InfluenceGroup& group : limb.primitive.influences.groups)
    for (std::size_t v = 0; v < group.vertex_count; ++v) {
      std::vector<Affined> matrices;
      std::vector<double> weights;
      for (std::size_t i = 0; i < group.influence_count; ++i) {
        const std::size_t at = group.first_influence + v * group.influence_count + i;
        matrices.push_back(limb.bent.exact[limb.primitive.influences.joints[at]]);
        weights.push_back(static_cast<double>(limb.primitive.influences.weights[at]));
      }
      const std::size_t vertex = group.first_vertex + v;
      const Affined m = reference::blend_matrices<double>(matrices, weights);
      EXPECT_LT(
          safe_length(found.positions[vertex] - transform_point(m, Vec3<double>(limb.primitive.positions[vertex]))),
          1e-14);
      EXPECT_LT(cost::angle_deg(glm::vec3(found.normals[vertex]),
                                transform_normal_outward(linear_part(m), Vec3<double>(limb.primitive.normals[vertex]))),
                1e-4);
    }
}

TEST(cost_limb, has_the_volume_of_a_cylinder) {
  const cost::Limb limb;
  constexpr double kSides = 48.0;
  const double section = 0.5 * kSides * 0.25 * std::sin(2.0 * 3.14159265358979 / kSides);
  EXPECT_NEAR(cost::volume_of(limb.primitive.positions, limb.primitive.indices), 4.0 * section, 1e-4);
}

VertexInfluences two_vertices() { return {{{0, 1, 1, 0}, {1, 1, 3, 1}}, {4, 1, 2, 3}, {1.0f, 0.6f, 0.3f, 0.1f}}; }

TEST(cost_influences, the_heaviest_are_kept_with_sum_one) {
  const VertexInfluences two = cost::heaviest_influences(two_vertices(), 2),
                         one = cost::heaviest_influences(two_vertices(), 1);
  EXPECT_THAT(two.joints, ElementsAre(4, 1, 2));
  EXPECT_THAT(two.weights, ElementsAre(1.0f, testing::FloatEq(2.0f / 3.0f), testing::FloatEq(1.0f / 3.0f)));
  ASSERT_EQ(one.groups.size(), 1u) << "runs of equal counts are one group";
  EXPECT_EQ(one.groups[0].vertex_count, 2u);
  EXPECT_THAT(one.weights, ElementsAre(1.0f, 1.0f));
}

TEST(cost_influences, whole_weights_of_every_vertex_have_sum_one) {
  VertexInfluences many;
  many.groups = {{0, 4, 2, 0}, {4, 3, 3, 8}};
  for (int i = 0; i < 4; ++i) many.weights.insert(many.weights.end(), {0.5f, 0.5f});
  for (int i = 0; i < 3; ++i) many.weights.insert(many.weights.end(), {0.5f, 0.25f, 0.25f});
  many.joints.resize(many.weights.size());
  const auto whole = cost::whole_weights<std::uint8_t>(many);
  for (std::size_t v = 0; v < 4; ++v) EXPECT_EQ(whole[2 * v] + whole[2 * v + 1], 255) << v;
  for (std::size_t v = 0; v < 3; ++v) EXPECT_EQ(whole[8 + 3 * v] + whole[9 + 3 * v] + whole[10 + 3 * v], 255) << v;
}

TEST(cost_influences, whole_weights_have_sum_one_and_the_heaviest_takes_what_is_missing) {
  const VertexInfluences two{
      {{0, 1, 1, 0}, {1, 1, 3, 1}}, {4, 1, 2, 3}, {1.0f, 0.5f, 0.2505f, 0.2495f}};  // times 255: 127.5 63.9 63.6
  EXPECT_THAT(cost::whole_weights<std::uint8_t>(two), ElementsAre(255, 127, 64, 64));
  EXPECT_THAT(cost::whole_weights<std::uint16_t>(two_vertices()), ElementsAre(65535, 39320, 19661, 6554));
}

cost::Point point(double error, double time_ns) {
  cost::Point p;
  p.error = error;
  p.time_ns = time_ns;
  return p;
}

std::vector<bool> front_of(cost::Group group) {
  cost::mark_pareto_front(group);
  std::vector<bool> front;
  for (const cost::Point& p : group.points) front.push_back(p.pareto);
  return front;
}

TEST(cost_pareto_front, holds_what_nothing_beats) {
  cost::Group group;
  group.points = {point(1.0, 5.0), point(2.0, 4.0), point(2.0, 5.0), point(0.5, 9.0), point(1.5, 4.5), point(0.5, 9.0)};
  EXPECT_THAT(front_of(group), ElementsAre(true, true, false, true, true, true))
      << "of two equal points both are on it";
}

TEST(cost_pareto_front, takes_errors_below_rounding_for_equal) {
  cost::Group group;
  group.points = {point(2e-7, 5.0), point(1e-7, 6.0)};
  EXPECT_THAT(front_of(group), ElementsAre(true, true));
  group.rounding = 3e-7;
  EXPECT_THAT(front_of(group), ElementsAre(true, false));
}

TEST(cost_pareto_front, leaves_points_of_another_aim_aside) {
  cost::Group group;
  group.points = {point(1.0, 5.0), point(0.5, 1.0)};
  group.points[1].other_aim = true;
  EXPECT_THAT(front_of(group), ElementsAre(true, false));
}

TEST(cost_pareto_front, weighs_sizes_where_a_group_is_about_them) {
  cost::Group group;
  group.size_unit = "bytes";
  group.points = {point(1.0, 9.0), point(1.0, 1.0)};
  group.points[0].size = 10.0;
  group.points[1].size = 20.0;
  EXPECT_THAT(front_of(group), ElementsAre(true, false));
}

TEST(cost_measure, middle_and_spread_are_those_of_the_quartiles) {
  double values[] = {9.0, 1.0, 2.0, 4.0, 3.0};
  const cost::Middle middle = cost::middle_of(values);
  EXPECT_EQ(middle.median, 3.0);
  EXPECT_DOUBLE_EQ(middle.spread, (4.0 - 2.0) / 3.0);
  EXPECT_EQ(cost::middle_of({}).median, 0.0);
}

TEST(cost_measure, longer_work_takes_longer_and_hooks_are_called_around_it) {
  std::vector<cost::Study> studies(1);
  int inside = 0, outside = 0;
  bool within = false;
  volatile double sum = 0.0;
  const auto work = [&](int turns) {
    return cost::Work{1,
                      [&, turns] {
                        for (int i = 0; i < turns; ++i) sum = sum + 1.0;
                        (within ? inside : outside)++;
                      },
                      [&] { within = true; }, [&] { within = false; }};
  };
  studies[0].add(point(0.0, 0.0), work(2'000));
  studies[0].add(point(0.0, 0.0), work(200'000));
  double last = 0.0;
  cost::measure(studies, {3, 0.001, 1, 1}, [&](double done) { last = done; });
  const auto& points = studies[0].group.points;
  EXPECT_GT(points[1].time_ns, 10.0 * points[0].time_ns);
  EXPECT_TRUE(points[0].pareto);
  EXPECT_FALSE(points[1].pareto);
  EXPECT_GT(inside, 5);
  EXPECT_EQ(outside, 0);
  EXPECT_GT(last, 0.3);
}

TEST(cost_words, numbers_have_three_digits_and_lengths_a_fitting_unit) {
  EXPECT_EQ(cost::number(12.345), "12.3");
  EXPECT_EQ(cost::number(0.0012345), "0.00123");
  EXPECT_EQ(cost::number(0.00012345), "0.000123");
  EXPECT_EQ(cost::number(1234.5), "1234");
  EXPECT_EQ(cost::number(3.4e-7), "3.4e-07");
  EXPECT_EQ(cost::length(0.00035), "0.35 um");
  EXPECT_EQ(cost::length(84.71), "84.7 mm");
}

TEST(cost_words, the_cheapest_is_the_default_unless_another_is_clearly_cheaper) {
  cost::Group group;
  group.points = {point(0.1, 0.97), point(0.0, 1.0), point(0.1, 0.9), point(5.0, 0.1)};
  group.points[1].is_default = true;
  EXPECT_EQ(cost::cheapest_within(group, 1.0), &group.points[2]);
  group.points[2].time_ns = 0.98;
  EXPECT_EQ(cost::cheapest_within(group, 1.0), &group.points[1]);
  EXPECT_EQ(cost::cheapest_within(group, -1.0), nullptr);
}

}  // namespace
}  // namespace sinew::test
