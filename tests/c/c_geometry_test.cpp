// SPDX-License-Identifier: MIT
// Geometry caches give the same vertices through the C interface as through the C++ interface.
#include <gtest/gtest.h>

#include <limits>

#include "runtime/base/same_bits.h"
#include "runtime/c/handles.h"
#include "runtime/geometry_cache/geometry_decoder.h"
#include "runtime/plan/frame_result.h"
#include "tests/c/engine_geometry.h"
#include "tests/geometry_cache/takes.h"

namespace sinew::test {
namespace {

class c_geometry : public testing::Test {
 protected:
  c_geometry() {
    file_.bytes = reinterpret_cast<const unsigned char*>(bytes_.data());
    file_.byte_count = bytes_.size();
  }
  ~c_geometry() override { engine_cloth_destroy(&cloth_); }

  std::vector<glm::vec3> truth(double time_s) {
    GeometryDecoder decoder(cache_);
    MappedFrames frames{cache_, bytes_};
    EXPECT_EQ(decoder.decode_time(time_s, frames), GeometryStatus::ok);
    std::vector<glm::vec3> out(cache_.meshes()[0].vertex_count);
    EXPECT_EQ(decoder.write_vertices(0, out), GeometryStatus::ok);
    return out;
  }
  void expect_shown(const std::vector<glm::vec3>& expected) {
    sinew_shape shape{};
    shape.struct_size = sizeof(shape);
    ASSERT_EQ(sinew_get_shape(sinew_frame_result(cloth_.frame), 0, &shape), SINEW_OK);
    ASSERT_EQ(shape.positions.count, expected.size());
    EXPECT_EQ(std::memcmp(shape.positions.data, expected.data(), expected.size() * sizeof(glm::vec3)), 0);
  }
  sinew_instance_result instance() {
    sinew_instance_result out{};
    out.struct_size = sizeof(out);
    EXPECT_EQ(sinew_get_instance_result(sinew_frame_result(cloth_.frame), 0, &out), SINEW_OK);
    return out;
  }

  std::vector<std::byte> bytes_ = *encode_geometry_cache(flag_take(20), {.segment_frames = 8});
  GeometryCache cache_ = *GeometryCache::open(bytes_);
  engine_file file_{};
  engine_cloth cloth_{};
};

TEST_F(c_geometry, a_cache_in_memory_shows_the_vertices_of_the_decoder) {
  ASSERT_EQ(engine_cloth_create(&file_, 0, &cloth_), SINEW_OK);
  for (const double time_s : {0.0, 0.25, 0.1, 0.333}) {
    ASSERT_EQ(engine_cloth_run(&cloth_, time_s, 1.0f), SINEW_OK);
    expect_shown(truth(time_s));
    EXPECT_EQ(instance().from_cache, 1u);
    EXPECT_EQ(instance().late, 0u);
    sinew_box box{};
    ASSERT_EQ(sinew_geometry_player_bounds(cloth_.player, 0, time_s, &box), SINEW_OK);
    EXPECT_EQ(box.upper.x, instance().bounds.upper.x);
  }
  EXPECT_EQ(file_.reads, 0u);
  ASSERT_EQ(engine_cloth_run(&cloth_, 0.1, 0.0f), SINEW_OK);
  EXPECT_EQ(instance().from_cache, 0u);
  expect_shown(truth(0.0));  // at rest as in the first frame
}

TEST_F(c_geometry, frames_that_the_engine_reads_later_show_the_newest_and_say_so) {
  file_.later = 1;
  ASSERT_EQ(engine_cloth_create(&file_, 1, &cloth_), SINEW_OK);
  ASSERT_EQ(engine_cloth_run(&cloth_, 0.0, 1.0f), SINEW_OK);
  EXPECT_EQ(instance().late, 1u);
  EXPECT_EQ(instance().from_cache, 0u);
  sinew_geometry_work work{};
  work.struct_size = sizeof(work);
  ASSERT_EQ(sinew_geometry_player_work(cloth_.player, &work), SINEW_OK);
  EXPECT_EQ(work.pending_reads, 4u);
  engine_deliver(&file_);
  ASSERT_EQ(engine_cloth_run(&cloth_, 0.0, 1.0f), SINEW_OK);
  EXPECT_EQ(instance().late, 0u);
  expect_shown(truth(0.0));
  ASSERT_EQ(engine_cloth_run(&cloth_, cache_.frame_s() * 6, 1.0f), SINEW_OK);
  EXPECT_EQ(instance().late, 1u) << "four frames were there";
  expect_shown(truth(cache_.frame_s() * 3));
  for (int k = 0; k < 2; ++k) {  // the window of requested frames moves on to frame 6
    engine_deliver(&file_);
    ASSERT_EQ(engine_cloth_run(&cloth_, cache_.frame_s() * 6, 1.0f), SINEW_OK);
  }
  EXPECT_EQ(instance().late, 0u);
  expect_shown(truth(cache_.frame_s() * 6));
  engine_deliver(&file_);
}

TEST_F(c_geometry, it_says_what_is_in_the_file) {
  ASSERT_EQ(engine_cloth_create(&file_, 0, &cloth_), SINEW_OK);
  sinew_geometry_info info{};
  info.struct_size = sizeof(info);
  ASSERT_EQ(sinew_geometry_get_info(cloth_.cache, &info), SINEW_OK);
  EXPECT_EQ(info.mesh_count, 1u);
  EXPECT_EQ(info.frame_count, 20u);
  EXPECT_EQ(info.duration_s, cache_.duration_s());
  EXPECT_EQ(info.largest_frame_bytes, cache_.largest_frame());
  sinew_geometry_mesh mesh{};
  mesh.struct_size = sizeof(mesh);
  ASSERT_EQ(sinew_geometry_get_mesh(cloth_.cache, 0, &mesh), SINEW_OK);
  EXPECT_EQ(std::string(mesh.name.data, mesh.name.length), "mesh");
  EXPECT_EQ(mesh.triangle_count, cache_.meshes()[0].triangles.size() / 3);
  EXPECT_EQ(mesh.measured_m, cache_.meshes()[0].streams[0].measured);
  EXPECT_EQ(sinew_geometry_get_mesh(cloth_.cache, 1, &mesh), SINEW_INDEX_OUT_OF_RANGE);
}

TEST_F(c_geometry, bad_files_and_calls_answer_codes) {
  sinew_geometry_cache* cache = nullptr;
  sinew_messages* messages = nullptr;
  EXPECT_EQ(sinew_geometry_open(bytes_.data(), 50, 50, &cache, &messages), SINEW_BAD_FILE);
  ASSERT_EQ(sinew_message_count(messages), 1u);
  EXPECT_TRUE(std::string(sinew_message(messages, 0)).starts_with("cache-size: byte "));
  sinew_messages_destroy(messages);
  EXPECT_EQ(sinew_geometry_open(nullptr, 0, 0, &cache, nullptr), SINEW_NULL_ARGUMENT);
  ASSERT_EQ(engine_cloth_create(&file_, 0, &cloth_), SINEW_OK);
  EXPECT_EQ(engine_cloth_run(&cloth_, std::numeric_limits<double>::quiet_NaN(), 1.0f), SINEW_NOT_FINITE);
  EXPECT_EQ(engine_cloth_run(&cloth_, 0.0, 1.5f), SINEW_NOT_A_FRACTION);
  sinew_geometry_player* player = nullptr;
  sinew_geometry_player_options options = sinew_default_geometry_player_options();
  const sinew_geometry_binding outside{1, 0, 0};
  options.bindings = &outside;
  options.binding_count = 1;
  EXPECT_EQ(sinew_geometry_player_create(cloth_.cache, cloth_.scene, &options, &player, nullptr),
            SINEW_INDEX_OUT_OF_RANGE);
  options = sinew_default_geometry_player_options();
  options.reader = engine_file_reader(&file_);
  options.window_frames = 0;
  EXPECT_EQ(sinew_geometry_player_create(cloth_.cache, cloth_.scene, &options, &player, nullptr), SINEW_UNSUPPORTED);
  options.struct_size = 3;
  EXPECT_EQ(sinew_geometry_player_create(cloth_.cache, cloth_.scene, &options, &player, nullptr),
            SINEW_WRONG_STRUCT_SIZE);
  const std::uint32_t twice[] = {0, 0};
  sinew_needs needs = sinew_default_needs();
  needs.cached_instances = {twice, 2};
  sinew_plan* plan = nullptr;
  EXPECT_EQ(sinew_plan_create(cloth_.scene, &needs, &plan), SINEW_INDEX_OUT_OF_RANGE);
  const sinew_geometry_input none[2] = {};
  sinew_frame_input input = sinew_default_input();
  input.geometry = none;
  input.geometry_count = 2;
  EXPECT_EQ(sinew_run(cloth_.frame, &input), SINEW_SIZE_MISMATCH);
  input.geometry_count = 1;
  EXPECT_EQ(sinew_run(cloth_.frame, &input), SINEW_OK) << "no source: nothing plays";
  sinew_scene* other = new sinew_scene{Scene{}};
  sinew_messages* unbound = nullptr;
  EXPECT_EQ(sinew_geometry_player_create(cloth_.cache, other, nullptr, &player, &unbound), SINEW_UNSUPPORTED);
  EXPECT_EQ(sinew_message_count(unbound), 1u);
  sinew_messages_destroy(unbound);
  sinew_scene_destroy(other);
}

TEST_F(c_geometry, characters_of_jobs_play_and_held_inputs_hold_what_plays) {
  ASSERT_EQ(engine_cloth_create(&file_, 0, &cloth_), SINEW_OK);
  sinew_jobs* jobs = nullptr;
  ASSERT_EQ(sinew_jobs_create(nullptr, &jobs), SINEW_OK);
  std::uint32_t character = 0;
  ASSERT_EQ(sinew_jobs_add_character(jobs, cloth_.plan, &character), SINEW_OK);
  sinew_geometry_input geometry{sinew_geometry_player_source(cloth_.player), 0.2, 1.0f};
  sinew_frame_input input = sinew_default_input();
  input.geometry = &geometry;
  input.geometry_count = 1;
  sinew_held_input* held = nullptr;
  ASSERT_EQ(sinew_held_input_create(cloth_.plan, &held), SINEW_OK);
  for (std::uint64_t frame = 0; frame < 2; ++frame) {
    geometry.time_s = 0.2 + 0.1 * static_cast<double>(frame);
    sinew_frame_input now = sinew_default_input();
    ASSERT_EQ(sinew_held_input_next(held, &input, SINEW_UPDATE_EVERY_SECOND, frame, 0, &now), SINEW_OK);
    std::uint64_t ticket = 0;
    ASSERT_EQ(sinew_jobs_submit(jobs, &now, 1, &ticket), SINEW_OK);
    ASSERT_EQ(sinew_jobs_wait(jobs, ticket), SINEW_OK);
    sinew_shape shape{};
    shape.struct_size = sizeof(shape);
    ASSERT_EQ(sinew_get_shape(sinew_jobs_latest(jobs, character), 0, &shape), SINEW_OK);
    const std::vector<glm::vec3> expected = truth(0.2);
    EXPECT_EQ(std::memcmp(shape.positions.data, expected.data(), expected.size() * sizeof(glm::vec3)), 0);
  }
  sinew_held_input_destroy(held);
  sinew_jobs_destroy(jobs);
}

}  // namespace
}  // namespace sinew::test
