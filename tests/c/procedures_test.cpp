// SPDX-License-Identifier: MIT
// Feet, springs and eyes through the C interface give the bits of the C++ jobs, and refuse what these refuse.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "runtime/base/same_bits.h"
#include "runtime/c/handles.h"
#include "runtime/procedures/feet.h"
#include "runtime/procedures/look_at/look_at.h"
#include "runtime/procedures/springs/springs_job.h"
#include "runtime/sinew.h"
#include "tests/procedures/walker.h"
#include "tests/springs/spring_stage.h"
#include "tests/support/allocation_counter.h"

namespace sinew::test {
namespace {

template <class Handle>
using Owned = std::unique_ptr<Handle, void (*)(Handle*)>;

Scene scene_of(const Skeleton& skeleton) {
  Scene scene;
  scene.skeleton = skeleton;
  finish_scene(scene);
  return scene;
}

void expect_same_pose(const PoseSpan& a, const PoseSpan& b, std::size_t joints) {
  for (std::size_t j = 0; j < joints; ++j) EXPECT_TRUE(same_bits(a.get(j), b.get(j))) << "joint " << j;
}

double slope(double z) { return 0.2 * z; }
std::uint32_t find_in_c(void* calls, std::size_t, const sinew_point* place, sinew_ground_hit* hit) {
  ++*static_cast<int*>(calls);
  *hit = {slope(place->z), {0.0, 1.0, -0.2}};
  return 1;
}
bool find_in_cpp(void*, std::size_t, const Vec3<double>& place, GroundHit& hit) {
  hit = {slope(place.z), {0.0, 1.0, -0.2}};
  return true;
}

struct CFeet : testing::Test {
  Walker walker;
  sinew_scene scene{scene_of(walker.skeleton)};
  std::array<sinew_foot, 2> feet;
  sinew_feet_setup setup = sinew_default_feet_setup();

  CFeet() {
    for (std::uint32_t side = 0; side < 2; ++side)
      EXPECT_EQ(sinew_foot_on_rest_ground(&scene, scenes::left_thigh + side, scenes::left_shank + side,
                                          scenes::left_foot + side, scenes::left_toes + side, &feet[side]),
                SINEW_OK);
    setup.feet = feet.data();
    setup.foot_count = 2;
    setup.pelvis = scenes::hips;
  }
  Owned<sinew_feet> make() {
    sinew_feet* made = nullptr;
    EXPECT_EQ(sinew_feet_create(&scene, &setup, &made), SINEW_OK);
    return {made, sinew_feet_destroy};
  }
  sinew_feet_frame frame(int index, int* calls) const {
    sinew_feet_frame frame = sinew_default_feet_frame();
    frame.root.row[2][3] = index / 60.0;
    frame.root.row[1][3] = slope(index / 60.0);
    frame.dt_s = index == 0 ? 0.0 : 1.0 / 60.0;
    frame.find = find_in_c;
    frame.context = calls;
    return frame;
  }
};

TEST_F(CFeet, walk_uphill_with_the_bits_of_the_job_and_without_allocating) {
  const Owned<sinew_feet> own = make();
  std::array<FootSetup, 2> legs;
  for (std::uint32_t side = 0; side < 2; ++side)
    legs[side] = foot_on_rest_ground(walker.skeleton, scenes::left_thigh + side, scenes::left_shank + side,
                                     scenes::left_foot + side, scenes::left_toes + side);
  FeetSetup same;
  same.pelvis = scenes::hips;
  same.feet = legs;
  FeetState state;
  std::vector<unsigned char> kept(sinew_feet_state_bytes());
  int calls = 0;
  for (int i = 0; i < 90; ++i) {
    PoseBuffer c = walker.pose(i / 60.0), cpp = walker.pose(i / 60.0);
    const sinew_pose local{c.span().planes, walker.skeleton.joint_count()};
    const sinew_feet_frame frame = this->frame(i, &calls);
    const AllocationCounter allocated;
    ASSERT_EQ(sinew_feet_begin_frame(own.get(), &frame), SINEW_OK);
    ASSERT_EQ(sinew_feet_run(own.get(), &local), SINEW_OK);
    EXPECT_EQ(allocated.count(), 0u);
    Affined root;
    for (int r = 0; r < 3; ++r)
      for (int column = 0; column < 4; ++column) root.row[r][column] = frame.root.row[r][column];
    std::array<FootResult, 2> results;
    const FeetJob job{.skeleton = &walker.skeleton,
                      .local = cpp.span(),
                      .setup = &same,
                      .root = root,
                      .dt_s = frame.dt_s,
                      .ground = {find_in_cpp, nullptr},
                      .state = &state,
                      .results = results};
    ASSERT_EQ(run(job), ErrorCode::ok);
    expect_same_pose(c.span(), cpp.span(), walker.skeleton.joint_count());
    sinew_foot_result result{.struct_size = sizeof(result)};
    ASSERT_EQ(sinew_get_foot_result(own.get(), 1, &result), SINEW_OK);
    EXPECT_EQ(result.is_locked != 0, results[1].is_locked);
    EXPECT_EQ(result.heel_above_ground_m, results[1].heel_above_ground_m);
  }
  EXPECT_GE(calls, 90 * 4);

  // The state rolls back: the same frame again gives the same pose.
  ASSERT_EQ(sinew_feet_get_state(own.get(), kept.data(), kept.size()), SINEW_OK);
  const sinew_feet_frame next = frame(90, &calls);
  ASSERT_EQ(sinew_feet_begin_frame(own.get(), &next), SINEW_OK);
  PoseBuffer once = walker.pose(1.5), again = walker.pose(1.5);
  sinew_pose_procedure procedure{};
  ASSERT_EQ(sinew_feet_procedure(own.get(), &procedure), SINEW_OK);
  EXPECT_EQ(procedure.version, 0u);
  sinew_procedure_pose given{.struct_size = sizeof(given), .local = {once.span().planes, 9}, .share = 1.0f};
  procedure.run(procedure.context, &given);
  ASSERT_EQ(sinew_feet_set_state(own.get(), kept.data(), kept.size()), SINEW_OK);
  given.local.planes = again.span().planes;
  procedure.run(procedure.context, &given);
  expect_same_pose(once.span(), again.span(), walker.skeleton.joint_count());
}

TEST_F(CFeet, refuse_what_the_job_refuses) {
  sinew_feet* made = nullptr;
  const auto refused = [&](auto change) {
    sinew_feet_setup bad = setup;
    change(bad);
    return sinew_feet_create(&scene, &bad, &made);
  };
  EXPECT_EQ(refused([](auto& s) { s.pelvis = 99; }), SINEW_INDEX_OUT_OF_RANGE);
  EXPECT_EQ(refused([](auto& s) { s.pelvis = scenes::left_foot; }), SINEW_UNSUPPORTED);
  EXPECT_EQ(refused([](auto& s) { s.half_life_s = -1.0; }), SINEW_NOT_A_FRACTION);
  EXPECT_EQ(refused([](auto& s) { s.most_slope_rad = std::numeric_limits<double>::quiet_NaN(); }), SINEW_NOT_FINITE);
  EXPECT_EQ(refused([](auto& s) { s.feet = nullptr; }), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(refused([](auto& s) { s.struct_size = 8; }), SINEW_WRONG_STRUCT_SIZE);
  const std::vector<sinew_foot> many(SINEW_MOST_FEET + 1, feet[0]);
  EXPECT_EQ(refused([&](auto& s) {
              s.feet = many.data();
              s.foot_count = many.size();
            }),
            SINEW_SIZE_MISMATCH);
  EXPECT_EQ(made, nullptr);
  EXPECT_EQ(sinew_foot_on_rest_ground(&scene, 0, 1, 99, SINEW_NONE, feet.data()), SINEW_INDEX_OUT_OF_RANGE);

  const Owned<sinew_feet> own = make();
  sinew_feet_frame frame = sinew_default_feet_frame();
  frame.dt_s = -1.0;
  EXPECT_EQ(sinew_feet_begin_frame(own.get(), &frame), SINEW_TIMES_NOT_INCREASING);
  frame.dt_s = 0.0;
  frame.root.row[1][2] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(sinew_feet_begin_frame(own.get(), &frame), SINEW_NOT_FINITE);
  sinew_foot_result result{.struct_size = sizeof(result)};
  EXPECT_EQ(sinew_get_foot_result(own.get(), 2, &result), SINEW_INDEX_OUT_OF_RANGE);
  PoseBuffer other(20);
  const sinew_pose local{other.span().planes, 20};
  EXPECT_EQ(sinew_feet_run(own.get(), &local), SINEW_SIZE_MISMATCH);
  char byte = 0;
  EXPECT_EQ(sinew_feet_get_state(own.get(), &byte, 1), SINEW_SIZE_MISMATCH);
  EXPECT_EQ(sinew_feet_set_state(own.get(), &byte, 1), SINEW_SIZE_MISMATCH);
  EXPECT_EQ(sinew_feet_get_state(own.get(), nullptr, 1), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_feet_create(nullptr, &setup, &made), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_feet_begin_frame(own.get(), nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_feet_run(nullptr, &local), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_feet_procedure(own.get(), nullptr), SINEW_NULL_ARGUMENT);
  sinew_feet_destroy(nullptr);
}

/// A hanging chain of four springs with a sphere beside it, in C and in C++.
struct CSprings : testing::Test {
  HangingChain chain;
  sinew_scene scene{scene_of(chain.skeleton)};
  std::uint32_t sphere = 0;
  sinew_spring_group group{SINEW_NONE, SINEW_SPRING_TO_REST, &sphere, 1};
  sinew_spring_collider collider{SINEW_COLLIDER_SPHERE, 0, {0.6, -2.0, 0.0}, {0, 0, 0}, {0, 1, 0}, 0.5, 0};
  std::vector<sinew_spring_joint> joints;
  sinew_springs_setup setup = sinew_default_springs_setup();

  CSprings() {
    chain.setup.groups[0].colliders = {0};
    chain.setup.colliders = {{.joint = 0, .offset = {0.6, -2.0, 0.0}, .radius_m = 0.5}};
    for (std::uint32_t j = 1; j <= 4; ++j) {
      joints.push_back(sinew_default_spring_joint(j));
      joints.back().tail_m = {0.0, -1.0, 0.0};
    }
    setup.groups = &group;
    setup.group_count = 1;
    setup.joints = joints.data();
    setup.joint_count = joints.size();
    setup.colliders = &collider;
    setup.collider_count = 1;
  }
  Owned<sinew_springs> make() {
    sinew_springs* made = nullptr;
    EXPECT_EQ(sinew_springs_create(&scene, &setup, &made, nullptr), SINEW_OK);
    return {made, sinew_springs_destroy};
  }
  static Owned<sinew_spring_motion> move(const Owned<sinew_springs>& springs) {
    sinew_spring_motion* made = nullptr;
    EXPECT_EQ(sinew_spring_motion_create(springs.get(), &made), SINEW_OK);
    return {made, sinew_spring_motion_destroy};
  }
  PoseBuffer rest() const {
    PoseBuffer pose(chain.skeleton.joint_count());
    for (std::size_t j = 0; j < chain.skeleton.joint_count(); ++j) pose.span().set(j, chain.skeleton.rest[j]);
    return pose;
  }
};

TEST_F(CSprings, swing_with_the_bits_of_the_job_and_without_allocating) {
  const Owned<sinew_springs> springs = make();
  const Owned<sinew_spring_motion> motion = move(springs);
  SpringStage stage(chain.skeleton, chain.setup);
  std::vector<sinew_point> tails(4);
  for (int i = 0; i < 120; ++i) {
    const Vec3<double> at = figure_of_eight(i / 45.0);
    sinew_spring_frame frame = sinew_default_spring_frame();
    frame.dt_s = 1.0 / 45.0;
    for (int r = 0; r < 3; ++r) frame.root.row[r][3] = at[r];
    frame.event = i == 60 ? SINEW_SPRINGS_TELEPORT : SINEW_SPRINGS_GO_ON;
    frame.tails = tails.data();
    frame.tail_count = tails.size();
    stage.event = i == 60 ? SpringEvent::teleport : SpringEvent::none;
    stage.move_root(at);
    stage.frame(1.0 / 45.0);
    PoseBuffer pose = rest();
    const sinew_pose local{pose.span().planes, chain.skeleton.joint_count()};
    const AllocationCounter allocated;
    ASSERT_EQ(sinew_spring_motion_begin_frame(motion.get(), &frame), SINEW_OK);
    ASSERT_EQ(sinew_spring_motion_run(motion.get(), &local), SINEW_OK);
    EXPECT_EQ(allocated.count(), 0u);
    for (std::size_t s = 0; s < 4; ++s) {
      EXPECT_TRUE(same_bits(pose.span().get(s + 1).rotation, stage.rotation(s + 1))) << i;
      EXPECT_EQ(tails[s].x, stage.tails[s].x);
    }
    sinew_spring_result result{.struct_size = sizeof(result)};
    ASSERT_EQ(sinew_get_spring_result(motion.get(), &result), SINEW_OK);
    EXPECT_EQ(result.error, SINEW_OK);
    EXPECT_EQ(result.ticks, stage.counts.ticks);
  }
}

TEST_F(CSprings, roll_back_and_promise_a_version_only_while_they_sleep) {
  const Owned<sinew_springs> springs = make();
  const Owned<sinew_spring_motion> motion = move(springs);
  std::vector<unsigned char> kept(sinew_spring_motion_state_bytes(motion.get()));
  sinew_spring_frame frame = sinew_default_spring_frame();
  frame.dt_s = 1.0 / 60.0;
  const auto step = [&](double x) {
    frame.root.row[0][3] = x;
    EXPECT_EQ(sinew_spring_motion_begin_frame(motion.get(), &frame), SINEW_OK);
    PoseBuffer pose = rest();
    sinew_pose_procedure procedure{};
    EXPECT_EQ(sinew_spring_motion_procedure(motion.get(), &procedure), SINEW_OK);
    sinew_procedure_pose given{.struct_size = sizeof(given), .local = {pose.span().planes, 6}, .share = 1.0f};
    procedure.run(procedure.context, &given);
    return std::pair(pose.span().get(4).rotation, procedure.version);
  };
  for (int i = 0; i < 20; ++i) EXPECT_EQ(step(0.02 * i).second, 0u);
  ASSERT_EQ(sinew_spring_motion_get_state(motion.get(), kept.data(), kept.size()), SINEW_OK);
  const glm::quat once = step(0.5).first;
  ASSERT_EQ(sinew_spring_motion_set_state(motion.get(), kept.data(), kept.size()), SINEW_OK);
  EXPECT_TRUE(same_bits(step(0.5).first, once));
  for (int i = 0; i < 3000; ++i) step(0.5);
  EXPECT_NE(step(0.5).second, 0u) << "they sleep";
}

TEST_F(CSprings, refuse_with_a_line_that_names_the_entry) {
  sinew_springs* made = nullptr;
  sinew_messages* why = nullptr;
  joints[2].joint = joints[1].joint;
  EXPECT_EQ(sinew_springs_create(&scene, &setup, &made, &why), SINEW_INDEX_OUT_OF_RANGE);
  ASSERT_EQ(sinew_message_count(why), 1u);
  EXPECT_NE(std::string(sinew_message(why, 0)).find("joints[2]"), std::string::npos) << sinew_message(why, 0);
  sinew_messages_destroy(why);
  joints[2].joint = 3;
  collider.kind = 3;
  EXPECT_EQ(sinew_springs_create(&scene, &setup, &made, nullptr), SINEW_UNSUPPORTED);
  collider.kind = SINEW_COLLIDER_SPHERE;
  setup.tick_s = -1.0;
  EXPECT_NE(sinew_springs_create(&scene, &setup, &made, nullptr), SINEW_OK);
  setup.tick_s = 1.0 / 60.0;
  EXPECT_EQ(made, nullptr);
  EXPECT_EQ(sinew_springs_create(&scene, nullptr, &made, nullptr), SINEW_NULL_ARGUMENT);

  const Owned<sinew_springs> springs = make();
  const Owned<sinew_spring_motion> motion = move(springs);
  sinew_spring_frame frame = sinew_default_spring_frame();
  sinew_point tails[3];
  frame.event = 3;
  EXPECT_EQ(sinew_spring_motion_begin_frame(motion.get(), &frame), SINEW_UNSUPPORTED);
  frame = sinew_default_spring_frame();
  frame.dt_s = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(sinew_spring_motion_begin_frame(motion.get(), &frame), SINEW_NOT_FINITE);
  frame = sinew_default_spring_frame();
  frame.tails = tails;
  frame.tail_count = 3;
  EXPECT_EQ(sinew_spring_motion_begin_frame(motion.get(), &frame), SINEW_SIZE_MISMATCH);
  EXPECT_EQ(sinew_spring_motion_set_state(motion.get(), tails, 1), SINEW_SIZE_MISMATCH);
  EXPECT_EQ(sinew_spring_motion_run(motion.get(), nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_spring_motion_create(nullptr, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_spring_motion_state_bytes(nullptr), 0u);
  sinew_springs_destroy(nullptr);
  sinew_spring_motion_destroy(nullptr);
}

TEST(c_look_at, turns_eyes_with_the_bits_of_the_job_and_refuses_what_it_refuses) {
  Skeleton skeleton = chain_skeleton(3);
  skeleton.parents[2] = 0;
  const sinew_scene scene{scene_of(skeleton)};
  sinew_eyes_setup setup = sinew_default_eyes_setup();
  EXPECT_EQ(setup.outer.output, EyesSetup{}.outer.output);
  setup.left = 1;
  setup.right = 2;
  setup.inner = {1.0f, 0.2f};
  sinew_look_at* made = nullptr;
  ASSERT_EQ(sinew_look_at_create(&scene, &setup, &made), SINEW_OK);
  const Owned<sinew_look_at> look{made, sinew_look_at_destroy};
  EyesSetup own{.head = 0, .left = 1, .right = 2};
  own.inner = {1.0f, 0.2f};
  const Eyes eyes = prepare_eyes(skeleton, own).value();
  PoseBuffer c(3), cpp(3);
  for (std::size_t j = 0; j < 3; ++j) {
    c.span().set(j, skeleton.rest[j]);
    cpp.span().set(j, skeleton.rest[j]);
  }
  const sinew_pose local{c.span().planes, 3};
  const sinew_point target{1.0, 0.5, 2.0};
  ASSERT_EQ(sinew_look_at_set_target(look.get(), &target, 0.75f), SINEW_OK);
  ASSERT_EQ(sinew_look_at_run(look.get(), &local), SINEW_OK);
  Gaze gaze;
  ASSERT_EQ(run(LookAtJob{&skeleton, cpp.span(), &eyes, {1.0, 0.5, 2.0}, 0.75f, &gaze}), ErrorCode::ok);
  expect_same_pose(c.span(), cpp.span(), 3);
  EXPECT_FALSE(same_bits(c.span().get(1), skeleton.rest[1])) << "it turns";
  sinew_gaze told{.struct_size = sizeof(told)};
  ASSERT_EQ(sinew_get_gaze(look.get(), &told), SINEW_OK);
  EXPECT_EQ(told.yaw_rad, gaze.yaw_rad);
  EXPECT_EQ(told.error, SINEW_OK);
  sinew_pose_procedure procedure{};
  ASSERT_EQ(sinew_look_at_procedure(look.get(), &procedure), SINEW_OK);
  EXPECT_NE(procedure.version, 0u);

  // Eyes of expressions get weights.
  setup.kind = SINEW_EYES_ARE_WEIGHTS;
  own.kind = EyeKind::weights;
  const Eyes weighed = prepare_eyes(skeleton, own).value();
  ASSERT_EQ(sinew_look_at_create(&scene, &setup, &made), SINEW_OK);
  const Owned<sinew_look_at> face{made, sinew_look_at_destroy};
  ASSERT_EQ(sinew_look_at_set_target(face.get(), &target, 1.0f), SINEW_OK);
  ASSERT_EQ(sinew_look_at_run(face.get(), &local), SINEW_OK);
  ASSERT_EQ(run(LookAtJob{&skeleton, cpp.span(), &weighed, {1.0, 0.5, 2.0}, 1.0f, &gaze}), ErrorCode::ok);
  ASSERT_EQ(sinew_get_gaze(face.get(), &told), SINEW_OK);
  EXPECT_EQ(std::vector<float>({told.yaw_rad, told.pitch_rad, told.left, told.right, told.up, told.down}),
            std::vector<float>({gaze.yaw_rad, gaze.pitch_rad, gaze.left, gaze.right, gaze.up, gaze.down}));
  EXPECT_NE(gaze.left, gaze.right);
  EXPECT_NE(gaze.up, gaze.down);

  const sinew_point nowhere{std::numeric_limits<double>::infinity(), 0, 0};
  EXPECT_EQ(sinew_look_at_set_target(look.get(), &nowhere, 1.0f), SINEW_NOT_FINITE);
  EXPECT_EQ(sinew_look_at_set_target(look.get(), &target, 1.5f), SINEW_NOT_A_FRACTION);
  EXPECT_EQ(sinew_look_at_set_target(look.get(), nullptr, 1.0f), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_look_at_run(look.get(), nullptr), SINEW_NULL_ARGUMENT);
  setup.head = 3;
  EXPECT_EQ(sinew_look_at_create(&scene, &setup, &made), SINEW_INDEX_OUT_OF_RANGE);
  setup.head = 0;
  setup.kind = 2;
  EXPECT_EQ(sinew_look_at_create(&scene, &setup, &made), SINEW_UNSUPPORTED);
  sinew_look_at_destroy(nullptr);
}

}  // namespace
}  // namespace sinew::test
