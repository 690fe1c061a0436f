// SPDX-License-Identifier: MIT
#include "runtime/c/jobs.h"

#include <gtest/gtest.h>

#include <cstring>
#include <span>
#include <vector>

#include "runtime/base/same_bits.h"
#include "runtime/c/handles.h"
#include "tests/c/engine.h"
#include "tests/c/numbers.h"
#include "tests/scenes/random_scene.h"

namespace sinew::test {
namespace {

TEST(c_jobs, characters_leave_follow_and_change_their_plans) {
  const sinew_scene scene{random_scene(8)};
  const sinew_needs needs = sinew_default_needs();
  sinew_needs few = sinew_default_needs();
  few.flags = SINEW_NEED_JOINTS;
  sinew_plan *plan = nullptr, *other = nullptr;
  ASSERT_EQ(sinew_plan_create(&scene, &needs, &plan), SINEW_OK);
  ASSERT_EQ(sinew_plan_create(&scene, &few, &other), SINEW_OK);
  sinew_jobs* jobs = nullptr;
  ASSERT_EQ(sinew_jobs_create(nullptr, &jobs), SINEW_OK);
  std::uint32_t id[3] = {};
  for (std::uint32_t& one : id) ASSERT_EQ(sinew_jobs_add_character(jobs, plan, &one), SINEW_OK);
  const auto run = [&](std::span<const sinew_character_input> changed) {
    std::uint64_t ticket = 0;
    EXPECT_EQ(sinew_jobs_submit_changed(jobs, changed.data(), changed.size(), &ticket), SINEW_OK);
    EXPECT_EQ(sinew_jobs_wait(jobs, ticket), SINEW_OK);
    EXPECT_EQ(sinew_jobs_last_error(jobs), SINEW_OK);
  };
  const auto info_of = [&](std::uint32_t character) {
    sinew_result_info info = {};
    info.struct_size = sizeof info;
    EXPECT_EQ(sinew_get_result(sinew_jobs_latest(jobs, character), &info), SINEW_OK);
    return info;
  };
  const sinew_layer layer{0.4, 0, SINEW_NONE, 1.0f, SINEW_LAYER_BLEND};
  sinew_frame_input moved = sinew_default_input();
  moved.layers = &layer;
  moved.layer_count = 1;
  moved.root.row[0][3] = 3.0f;
  const sinew_frame_input still = sinew_default_input();
  const sinew_character_input both[] = {{&moved, id[0], 0}, {&still, id[2], 0}};
  EXPECT_EQ(sinew_jobs_follow(jobs, id[2], id[0], 1), SINEW_OK);
  EXPECT_EQ(sinew_jobs_follow(jobs, id[0], id[2], 1), SINEW_FOLLOWS_ITSELF);
  run(both);
  EXPECT_EQ(sinew_jobs_latest(jobs, id[1]), nullptr) << "it has no input yet";
  sinew_frame_input placed = still;
  std::memcpy(&placed.root, &info_of(id[0]).model.data[1], sizeof placed.root);
  Numbers alone, following;
  ASSERT_EQ(engine_play(&scene, &needs, &placed, nullptr, &alone), SINEW_OK);
  ASSERT_EQ(engine_read(sinew_jobs_latest(jobs, id[2]), sinew_skin_count(&scene), &following), SINEW_OK);
  EXPECT_TRUE(same_bits<float>(alone.all(), following.all()));
  EXPECT_NE(info_of(id[0]).local.planes, nullptr);
  EXPECT_EQ(sinew_jobs_replace_plan(jobs, id[0], other), SINEW_OK);
  EXPECT_EQ(sinew_jobs_stop_following(jobs, id[2]), SINEW_OK);
  run({});
  EXPECT_EQ(info_of(id[0]).local.planes, nullptr) << "the other plan does not show it";
  EXPECT_NE(info_of(id[2]).model.data[0].row[0][3], placed.root.row[0][3]);
  EXPECT_EQ(sinew_jobs_remove_character(jobs, id[0]), SINEW_OK);
  EXPECT_EQ(sinew_jobs_latest(jobs, id[0]), nullptr);
  const sinew_indices left = sinew_jobs_characters(jobs);
  EXPECT_EQ(std::vector<std::uint32_t>(left.data, left.data + left.count), (std::vector<std::uint32_t>{id[1], id[2]}));
  for (const sinew_error error : {sinew_jobs_remove_character(jobs, id[0]), sinew_jobs_replace_plan(jobs, id[0], plan),
                                  sinew_jobs_follow(jobs, id[0], id[1], 0), sinew_jobs_stop_following(jobs, id[0]),
                                  sinew_jobs_submit_changed(jobs, both, 2, nullptr)})
    EXPECT_EQ(error, SINEW_UNKNOWN_CHARACTER);
  const sinew_character_input no_input = {nullptr, id[1], 0};
  EXPECT_EQ(sinew_jobs_submit_changed(jobs, &no_input, 1, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_jobs_submit_changed(jobs, nullptr, 1, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_jobs_characters(nullptr).count, 0u);
  sinew_jobs_destroy(jobs);
  sinew_plan_destroy(other);
  sinew_plan_destroy(plan);
}

}  // namespace
}  // namespace sinew::test
