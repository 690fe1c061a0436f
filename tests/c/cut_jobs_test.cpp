// SPDX-License-Identifier: MIT
// Frames of the C job thread that stop at a cut.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "runtime/math/decompose.h"
#include "tests/c/program_actor.h"

namespace sinew::test {
namespace {

class c_cut_jobs : public ProgramActor {
 protected:
  c_cut_jobs() {
    EXPECT_EQ(sinew_jobs_create(nullptr, &jobs_), SINEW_OK);
    EXPECT_EQ(sinew_jobs_add_character(jobs_, plan_, &character_), SINEW_OK);
  }
  ~c_cut_jobs() override { sinew_jobs_destroy(jobs_); }

  /// Submits a frame that stops at its cut, and returns the pose there.
  sinew_cut_pose stop(std::uint64_t& ticket, std::uint32_t ops) {
    const sinew_character_input changed{&input_, character_, ops};
    sinew_cut_pose cut{.struct_size = sizeof(cut)};
    EXPECT_EQ(sinew_jobs_submit_changed(jobs_, &changed, 1, &ticket), SINEW_OK);
    EXPECT_EQ(sinew_jobs_wait(jobs_, ticket), SINEW_OK);
    EXPECT_FALSE(sinew_jobs_done(jobs_, ticket));
    EXPECT_EQ(sinew_jobs_cut_pose(jobs_, character_, &cut), SINEW_OK);
    return cut;
  }

  sinew_jobs* jobs_ = nullptr;
  std::uint32_t character_ = 0;
};

TEST_F(c_cut_jobs, results_are_those_of_a_frame_cut_without_threads) {
  std::uint64_t ticket = 0;
  const sinew_cut_pose cut = stop(ticket, 3);
  sinew_cut_pose alone{.struct_size = sizeof(alone)};
  ASSERT_EQ(sinew_run_to_cut(frame_, &input_, 3, &alone), SINEW_OK);
  ASSERT_EQ(cut.model.count, alone.model.count);
  ASSERT_EQ(engine_place(&cut, {3.0f, 2.0f, 1.0f}), SINEW_OK);
  ASSERT_EQ(engine_place(&alone, {3.0f, 2.0f, 1.0f}), SINEW_OK);
  ASSERT_EQ(sinew_run_from_cut(frame_, &input_), SINEW_OK);
  EXPECT_EQ(sinew_jobs_latest(jobs_, character_), nullptr);
  EXPECT_EQ(sinew_jobs_resume(jobs_), SINEW_OK);
  EXPECT_EQ(sinew_jobs_wait(jobs_, ticket), SINEW_OK);
  EXPECT_TRUE(sinew_jobs_done(jobs_, ticket));
  EXPECT_EQ(sinew_jobs_last_error(jobs_), SINEW_OK);
  EXPECT_TRUE(same_bits<float>(all_numbers_of(sinew_jobs_latest(jobs_, character_)),
                               all_numbers_of(sinew_frame_result(frame_))));
}

TEST_F(c_cut_jobs, misuse_is_refused) {
  sinew_cut_pose pose{.struct_size = sizeof(pose)}, of_no_version{.struct_size = 3};
  EXPECT_EQ(sinew_jobs_resume(jobs_), SINEW_NO_CUT);
  EXPECT_EQ(sinew_jobs_cut_pose(jobs_, character_, &pose), SINEW_NO_CUT);
  std::uint64_t ticket = 0;
  const sinew_cut_pose cut = stop(ticket, SINEW_MOST_OPS);
  EXPECT_EQ(sinew_jobs_cut_pose(jobs_, character_ + 1, &pose), SINEW_NO_CUT);
  EXPECT_EQ(sinew_jobs_cut_pose(jobs_, character_, &of_no_version), SINEW_WRONG_STRUCT_SIZE);
  cut.local.planes[0] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(sinew_jobs_resume(jobs_), SINEW_OK);
  EXPECT_EQ(sinew_jobs_resume(jobs_), SINEW_NO_CUT);
  EXPECT_EQ(sinew_jobs_wait(jobs_, ticket), SINEW_OK);
  EXPECT_EQ(sinew_jobs_last_error(jobs_), SINEW_NOT_FINITE);
  EXPECT_EQ(sinew_jobs_latest(jobs_, character_), nullptr) << "no frame was good";
  sinew_needs needs = needs_of_c();
  needs.flags &= ~SINEW_NEED_CUT;
  sinew_plan* uncut = nullptr;
  ASSERT_EQ(sinew_plan_create(&scene_, &needs, &uncut), SINEW_OK);
  std::uint32_t other = 0;
  ASSERT_EQ(sinew_jobs_add_character(jobs_, uncut, &other), SINEW_OK);
  const sinew_character_input changed{&input_, other, 1};
  EXPECT_EQ(sinew_jobs_submit_changed(jobs_, &changed, 1, nullptr), SINEW_NOT_IN_NEEDS);
  sinew_jobs_destroy(std::exchange(jobs_, nullptr));
  sinew_plan_destroy(uncut);
}

TEST_F(c_cut_jobs, places_of_inputs_follow_joints_of_others) {
  joint_.space = SINEW_OVERRIDE_MODEL;
  sinew_affine target = {};
  const sinew_follow_place of_override{sizeof(of_override), SINEW_FOLLOW_JOINT_OVERRIDE, 0, 0, nullptr},
      of_procedure{sizeof(of_procedure), SINEW_FOLLOW_PROCEDURE, 0, 0, &target};
  std::uint32_t leader = 0;
  ASSERT_EQ(sinew_jobs_add_character(jobs_, plan_, &leader), SINEW_OK);
  ASSERT_EQ(sinew_jobs_follow_at(jobs_, character_, leader, 1, &of_override), SINEW_OK);
  ASSERT_EQ(sinew_jobs_follow_at(jobs_, character_, leader, 2, &of_procedure), SINEW_OK);
  sinew_frame_input stands = sinew_default_input();
  stands.root.row[0][3] = 4.0f;
  const sinew_character_input changed[] = {{&input_, character_, 0}, {&stands, leader, 0}};
  std::uint64_t ticket = 0;
  ASSERT_EQ(sinew_jobs_submit_changed(jobs_, changed, 2, &ticket), SINEW_OK);
  ASSERT_EQ(sinew_jobs_wait(jobs_, ticket), SINEW_OK);
  ASSERT_EQ(sinew_jobs_last_error(jobs_), SINEW_OK);
  sinew_result_info info{.struct_size = sizeof(info)};
  ASSERT_EQ(sinew_get_result(sinew_jobs_latest(jobs_, leader), &info), SINEW_OK);
  EXPECT_EQ(std::memcmp(&target, &info.model.data[2], sizeof(target)), 0) << "the follower's root is the identity";
  Affine held;
  std::memcpy(static_cast<void*>(&held), &info.model.data[1], sizeof(held));
  const Transform given{{0.5f, 1.0f, -2.0f}, quat_xyzw(0.6f, 0.0f, 0.0f, 0.8f)};
  OfCpp cpp(*this);
  cpp.joint.space = OverrideSpace::model;
  cpp.joint.transform = decompose_trs(held * affine_from_transform(given)).transform;
  FrameBuffer frame(cpp.plan);
  ASSERT_EQ(run_plan(cpp.plan, cpp.input, frame), ErrorCode::ok);
  EXPECT_TRUE(same_bits<float>(all_numbers_of(sinew_jobs_latest(jobs_, character_)),
                               all_numbers_of(reinterpret_cast<const sinew_result*>(&frame.result()))));
  sinew_follow_place bad = of_procedure;
  bad.matrix = nullptr;
  EXPECT_EQ(sinew_jobs_follow_at(jobs_, character_, leader, 1, &bad), SINEW_NULL_ARGUMENT);
  bad.kind = 3;
  EXPECT_EQ(sinew_jobs_follow_at(jobs_, character_, leader, 1, &bad), SINEW_UNSUPPORTED);
  bad.struct_size = 3;
  EXPECT_EQ(sinew_jobs_stop_following_at(jobs_, character_, &bad), SINEW_WRONG_STRUCT_SIZE);
  EXPECT_EQ(sinew_jobs_follow_at(jobs_, leader, character_, 1, nullptr), SINEW_FOLLOWS_ITSELF);
  EXPECT_EQ(sinew_jobs_stop_following_at(jobs_, 99, nullptr), SINEW_UNKNOWN_CHARACTER);
  EXPECT_EQ(sinew_jobs_stop_following_at(jobs_, character_, &of_override), SINEW_OK);
  EXPECT_EQ(sinew_jobs_stop_following_at(jobs_, character_, &of_procedure), SINEW_OK);
  EXPECT_EQ(sinew_jobs_follow_at(jobs_, leader, character_, 1, nullptr), SINEW_OK) << "nobody follows any more";
}

}  // namespace
}  // namespace sinew::test
