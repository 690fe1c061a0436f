// SPDX-License-Identifier: MIT
// Each required pointer of every C call is null in turn, while all other arguments are valid.
#include <gtest/gtest.h>

#include <memory>
#include <set>
#include <tuple>
#include <type_traits>
#include <utility>

#include "runtime/sinew.h"
#include "tests/c/c_frame.h"
#include "tests/scenes/hand_scenes.h"

namespace sinew::test {
namespace {

/// Calls the function with one required pointer null at a time and expects a refusal.
/// in   optional  indices of arguments that may be null
///      given     valid arguments; the call is never made with all of them
template <class... A>
void expect_refused(const char* name, sinew_error (*call)(A...), const std::set<std::size_t>& optional,
                    std::type_identity_t<A>... given) {
  const std::tuple<A...> good{given...};
  std::size_t tried = 0;
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    const auto without = [&]<std::size_t Index>(std::integral_constant<std::size_t, Index>) {
      if constexpr (std::is_pointer_v<std::tuple_element_t<Index, std::tuple<A...>>>) {
        if (optional.contains(Index)) return;
        auto bad = good;
        std::get<Index>(bad) = nullptr;
        EXPECT_EQ(std::apply(call, bad), SINEW_NULL_ARGUMENT) << name << ", argument " << Index;
        ++tried;
      }
    };
    (without(std::integral_constant<std::size_t, I>()), ...);
  }
  (std::index_sequence_for<A...>());
  EXPECT_GT(tried, 0u) << name;
}

#define EXPECT_REFUSED(call, ...) expect_refused(#call, call, __VA_ARGS__)

/// A handle that destroys its object.
template <class Handle>
using Own = std::unique_ptr<Handle, void (*)(Handle*)>;

class CNullArguments : public CFrame {
 protected:
  CNullArguments() : CFrame(arm_scene()) {}
};

TEST_F(CNullArguments, of_scenes) {
  sinew_instance instance{.struct_size = sizeof(instance)};
  sinew_primitive primitive{.struct_size = sizeof(primitive)};
  sinew_clip_block* block = nullptr;
  sinew_box box;
  std::size_t count = 0;
  const char bytes[8] = {};
  EXPECT_REFUSED(sinew_get_instance, {}, &scene_, 0, &instance);
  EXPECT_REFUSED(sinew_get_primitive, {}, &scene_, 0, 0, &primitive);
  EXPECT_REFUSED(sinew_clips_save, {}, &scene_, 0, 1, &block);
  EXPECT_REFUSED(sinew_clips_load, {4}, &scene_, 0, bytes, 8, nullptr);
  EXPECT_REFUSED(sinew_clip_bounds, {1}, &scene_, nullptr, 0, &box, 1, &count);
  EXPECT_EQ(sinew_find_joint(&scene_, nullptr), SINEW_NONE);
  EXPECT_EQ(sinew_find_clip(&scene_, nullptr), SINEW_NONE);
  EXPECT_EQ(sinew_find_mesh(&scene_, nullptr), SINEW_NONE);
}

TEST_F(CNullArguments, of_plans_and_frames) {
  sinew_plan* plan = nullptr;
  sinew_frame* frame = nullptr;
  sinew_messages* why = nullptr;
  sinew_stage stage{.struct_size = sizeof(stage)};
  sinew_result_info info{.struct_size = sizeof(info)};
  sinew_instance_result instance{.struct_size = sizeof(instance)};
  sinew_shape shape{.struct_size = sizeof(shape)};
  sinew_cut_pose cut{.struct_size = sizeof(cut)};
  sinew_program_room room{.struct_size = sizeof(room)};
  const sinew_pose_op op = sinew_default_op(SINEW_OP_REST);
  sinew_affine matrix;
  alignas(64) char block[64];
  EXPECT_REFUSED(sinew_plan_create, {1}, &scene_, nullptr, &plan);
  EXPECT_REFUSED(sinew_get_stage, {}, plan_, 0, &stage);
  EXPECT_REFUSED(sinew_frame_create, {1}, plan_, nullptr, &frame);
  EXPECT_REFUSED(sinew_frame_create_in, {}, plan_, block, sizeof(block), &frame);
  EXPECT_REFUSED(sinew_run, {1}, frame_, nullptr);
  EXPECT_REFUSED(sinew_run_to_cut, {1}, frame_, nullptr, 1, &cut);
  EXPECT_REFUSED(sinew_run_from_cut, {1}, frame_, nullptr);
  EXPECT_REFUSED(sinew_program_room_of, {}, &op, 1, &room);
  EXPECT_REFUSED(sinew_raise_program_room, {}, &room, &room);
  EXPECT_REFUSED(sinew_why_refused, {1}, frame_, nullptr, &why);
  EXPECT_REFUSED(sinew_get_result, {}, result_, &info);
  EXPECT_REFUSED(sinew_get_instance_result, {}, result_, 0, &instance);
  EXPECT_REFUSED(sinew_get_shape, {}, result_, 0, &shape);
  const sinew_vertex_buffer nowhere{.struct_size = sizeof(nowhere)};
  EXPECT_REFUSED(sinew_write_shape, {}, result_, 0, &nowhere);
  EXPECT_REFUSED(sinew_world_of, {3}, plan_, result_, 0, nullptr, &matrix);
  const auto allocate = [](void*, std::size_t, std::size_t) -> void* { return nullptr; };
  const auto release = [](void*, void*, std::size_t, std::size_t) {};
  sinew_allocator allocator{};
  allocator.allocate = allocate;
  EXPECT_EQ(sinew_frame_create(plan_, &allocator, &frame), SINEW_NULL_ARGUMENT);
  allocator.allocate = nullptr;
  allocator.release = release;
  EXPECT_EQ(sinew_frame_create(plan_, &allocator, &frame), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(plan, nullptr);
  EXPECT_EQ(frame, nullptr);
}

TEST_F(CNullArguments, of_jobs_and_inputs_between_frames) {
  sinew_jobs* made = nullptr;
  ASSERT_EQ(sinew_jobs_create(nullptr, &made), SINEW_OK);
  const Own<sinew_jobs> jobs(made, sinew_jobs_destroy);
  std::uint32_t character = 0, level = 0;
  std::uint64_t ticket = 0;
  sinew_held_input* held = nullptr;
  sinew_interpolated_input* interpolated = nullptr;
  sinew_frame_input input{.struct_size = sizeof(input)};
  EXPECT_REFUSED(sinew_jobs_create, {0}, nullptr, &made);
  EXPECT_REFUSED(sinew_jobs_add_character, {}, jobs.get(), plan_, &character);
  EXPECT_REFUSED(sinew_jobs_submit, {3}, jobs.get(), &input, 1, &ticket);
  EXPECT_REFUSED(sinew_jobs_wait, {}, jobs.get(), 0);
  sinew_cut_pose cut{.struct_size = sizeof(cut)};
  EXPECT_REFUSED(sinew_jobs_cut_pose, {}, jobs.get(), 0, &cut);
  EXPECT_EQ(sinew_jobs_resume(nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_jobs_follow_at(nullptr, 0, 1, 0, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_jobs_stop_following_at(nullptr, 0, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_REFUSED(sinew_jobs_last_error, {}, jobs.get());
  EXPECT_REFUSED(sinew_choose_update_level, {3}, 0.1, 0, 0.0, nullptr, &level);
  EXPECT_REFUSED(sinew_held_input_create, {}, plan_, &held);
  EXPECT_REFUSED(sinew_interpolated_input_create, {}, plan_, &interpolated);
  ASSERT_EQ(sinew_held_input_create(plan_, &held), SINEW_OK);
  EXPECT_REFUSED(sinew_held_input_next, {1}, held, nullptr, SINEW_UPDATE_EVERY, 0, 0, &input);
  sinew_held_input_destroy(held);
  sinew_needs needs = sinew_default_needs();
  needs.flags |= SINEW_NEED_BETWEEN_UPDATES;
  sinew_plan* between = nullptr;
  ASSERT_EQ(sinew_plan_create(&scene_, &needs, &between), SINEW_OK);
  ASSERT_EQ(sinew_interpolated_input_create(between, &interpolated), SINEW_OK);
  EXPECT_REFUSED(sinew_interpolated_input_next, {1, 2}, interpolated, nullptr, nullptr, 0, SINEW_UPDATE_EVERY, 0, 0,
                 &input);
  sinew_interpolated_input_destroy(interpolated);
  sinew_plan_destroy(between);
  sinew_task task{};
  EXPECT_FALSE(sinew_jobs_take_task(jobs.get(), nullptr));
  EXPECT_FALSE(sinew_jobs_take_task(nullptr, &task));
}

TEST_F(CNullArguments, of_clocks_and_root_motion) {
  sinew_clock clock;
  ASSERT_EQ(sinew_clock_init(&clock, 1.0, SINEW_PLAY_LOOP, 1.0), SINEW_OK);
  sinew_step step;
  ASSERT_EQ(sinew_clock_advance(&clock, 0.5, &step), SINEW_OK);
  sinew_dual_quat motion;
  EXPECT_REFUSED(sinew_clock_init, {}, &clock, 1.0, SINEW_PLAY_LOOP, 1.0);
  EXPECT_REFUSED(sinew_clock_advance, {2}, &clock, 0.5, &step);
  EXPECT_REFUSED(sinew_clock_seek, {}, &clock, 0.5);
  EXPECT_REFUSED(sinew_clock_set_speed, {}, &clock, 0.5);
  EXPECT_REFUSED(sinew_root_place, {3}, &scene_, 0, 2, nullptr, 0.5, &motion);
  EXPECT_REFUSED(sinew_root_motion, {3}, &scene_, 0, 2, nullptr, &step, &motion);
  const double event = 0.25;
  EXPECT_EQ(sinew_crossed_events(nullptr, &event, 1, nullptr, 0), 0u);
  EXPECT_EQ(sinew_crossed_events(&step, nullptr, 1, nullptr, 0), 0u);
}

TEST_F(CNullArguments, of_libraries_and_maps) {
  sinew_library *made = nullptr, *none = nullptr;
  ASSERT_EQ(sinew_library_create(&scene_, &made), SINEW_OK);
  const Own<sinew_library> library(made, sinew_library_destroy);
  ASSERT_EQ(sinew_library_add(library.get(), &scene_, SINEW_REFUSE, nullptr), SINEW_OK);
  sinew_skeleton_map* map_made = nullptr;
  ASSERT_EQ(sinew_skeleton_map_create(&scene_, &scene_, nullptr, &map_made), SINEW_OK);
  const Own<sinew_skeleton_map> map(map_made, sinew_skeleton_map_destroy);
  sinew_mirror* mirror_made = nullptr;
  ASSERT_EQ(sinew_mirror_create(&scene_, &mirror_made), SINEW_OK);
  const Own<sinew_mirror> mirror(mirror_made, sinew_mirror_destroy);
  sinew_skeleton_lod* lod_made = nullptr;
  ASSERT_EQ(sinew_skeleton_lod_create(&scene_, 0.0, nullptr, 0, nullptr, &lod_made), SINEW_OK);
  const Own<sinew_skeleton_lod> lod(lod_made, sinew_skeleton_lod_destroy);
  sinew_plan* plan = nullptr;
  sinew_skeleton_map_info map_info{.struct_size = sizeof(map_info)};
  sinew_mirror_info mirror_info{.struct_size = sizeof(mirror_info)};
  sinew_skeleton_lod_info lod_info{.struct_size = sizeof(lod_info)};
  sinew_root_track* track = nullptr;
  float ground = 0.0f;
  EXPECT_REFUSED(sinew_library_create, {}, &scene_, &none);
  EXPECT_REFUSED(sinew_library_add, {3}, library.get(), &scene_, SINEW_REFUSE, nullptr);
  EXPECT_REFUSED(sinew_library_add_retargeted, {5}, library.get(), map.get(), 0, 0, SINEW_REFUSE, nullptr);
  EXPECT_REFUSED(sinew_plan_create_from_library, {2, 3}, &scene_, library.get(), nullptr, nullptr, &plan);
  EXPECT_REFUSED(sinew_root_track_create, {4}, &scene_, library.get(), 0, 2, nullptr, &track);
  EXPECT_REFUSED(sinew_skeleton_map_create, {2}, &scene_, &scene_, nullptr, &map_made);
  EXPECT_REFUSED(sinew_get_skeleton_map, {}, map.get(), &map_info);
  EXPECT_REFUSED(sinew_find_ground, {}, map.get(), 0, &ground);
  EXPECT_REFUSED(sinew_mirror_create, {}, &scene_, &mirror_made);
  EXPECT_REFUSED(sinew_mirror_create_about, {2}, &scene_, SINEW_REFERENCE_BIND, nullptr, &mirror_made);
  EXPECT_EQ(sinew_mirror_create_about(&scene_, SINEW_REFERENCE_GIVEN, nullptr, &mirror_made), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_mirror_create_about(&scene_, 4, nullptr, &mirror_made), SINEW_UNSUPPORTED);
  EXPECT_REFUSED(sinew_get_mirror, {}, mirror.get(), &mirror_info);
  EXPECT_REFUSED(sinew_skeleton_lod_create, {2, 4}, &scene_, 0.1, nullptr, 0, nullptr, &lod_made);
  EXPECT_EQ(sinew_skeleton_lod_create(&scene_, 0.1, nullptr, 1, nullptr, &lod_made), SINEW_NULL_ARGUMENT);
  EXPECT_REFUSED(sinew_get_skeleton_lod, {}, lod.get(), &lod_info);
  EXPECT_EQ(sinew_library_find(library.get(), nullptr), SINEW_NONE);
  EXPECT_EQ(none, nullptr);
  EXPECT_EQ(plan, nullptr);
  EXPECT_EQ(track, nullptr);
}

TEST_F(CNullArguments, of_pages) {
  sinew_page* page = nullptr;
  sinew_paged_clip* paged = nullptr;
  ASSERT_EQ(sinew_page_create(&page), SINEW_OK);
  const Own<sinew_page> own_page(page, sinew_page_destroy);
  ASSERT_EQ(sinew_paged_clip_create(&scene_, 0, 0.5, 2, nullptr, &paged), SINEW_OK);
  const Own<sinew_paged_clip> own(paged, sinew_paged_clip_destroy);
  const char bytes[8] = {};
  std::size_t next = 0;
  EXPECT_REFUSED(sinew_page_create, {}, &page);
  EXPECT_REFUSED(sinew_paged_clip_create, {4}, &scene_, 0, 0.5, 2, nullptr, &paged);
  EXPECT_REFUSED(sinew_paged_clip_at, {}, own.get(), 0.0, 0, own_page.get());
  EXPECT_REFUSED(sinew_paged_clip_load_page, {4, 5}, own.get(), 0, bytes, 8, nullptr, nullptr);
  EXPECT_EQ(sinew_paged_clip_next_page(nullptr, &next), 0);
  EXPECT_EQ(sinew_paged_clip_next_page(own.get(), nullptr), 0);
}

TEST_F(CNullArguments, of_poses) {
  const std::size_t joints = scene_.scene.skeleton.joint_count();
  alignas(SINEW_POSE_ALIGNMENT) static float planes[2][1024];
  ASSERT_LE(sinew_pose_floats(joints), 1024u);
  const sinew_pose pose{planes[0], joints}, other{planes[1], joints}, without_planes{nullptr, joints};
  sinew_transform transform;
  std::vector<sinew_affine> model(joints);
  EXPECT_REFUSED(sinew_pose_rest, {}, &scene_, &pose);
  EXPECT_REFUSED(sinew_pose_sample, {}, &scene_, 0, 0.5, &pose);
  EXPECT_REFUSED(sinew_pose_get, {}, &pose, 0, &transform);
  EXPECT_REFUSED(sinew_pose_set, {}, &pose, 0, &transform);
  EXPECT_REFUSED(sinew_pose_to_model, {2}, &scene_, &pose, nullptr, model.data(), joints);
  EXPECT_EQ(sinew_pose_rest(&scene_, &without_planes), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_pose_get(&without_planes, 0, &transform), SINEW_NULL_ARGUMENT);
  sinew_mirror* mirror = nullptr;
  ASSERT_EQ(sinew_mirror_create(&scene_, &mirror), SINEW_OK);
  EXPECT_REFUSED(sinew_mirror_pose, {}, mirror, &pose, &other);
  sinew_mirror_destroy(mirror);
  sinew_skeleton_map* map = nullptr;
  ASSERT_EQ(sinew_skeleton_map_create(&scene_, &scene_, nullptr, &map), SINEW_OK);
  EXPECT_REFUSED(sinew_hold_feet, {}, map, 0.0f, &pose, &other);
  EXPECT_REFUSED(sinew_retarget_pose, {}, map, &pose, &pose, &other);
  sinew_skeleton_map_destroy(map);
}

}  // namespace
}  // namespace sinew::test
