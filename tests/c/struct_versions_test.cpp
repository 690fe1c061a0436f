// SPDX-License-Identifier: MIT
// Engines compiled with an older or a newer header: their structs and array elements are smaller or larger than the
// library's.
#include <gtest/gtest.h>

#include "runtime/base/same_bits.h"
#include "runtime/c/handles.h"
#include "runtime/c/page_handle.h"
#include "runtime/c/pages.h"
#include "runtime/c/skeleton_lod.h"
#include "tests/c/engine.h"
#include "tests/c/numbers.h"
#include "tests/scenes/random_scene.h"

namespace sinew::test {
namespace {

/// Structs as in the first version of the headers.
struct FirstInput {
  std::size_t struct_size = sizeof(FirstInput);
  const sinew_layer* layers = nullptr;
  std::size_t layer_count = 0;
  sinew_floats weights = {nullptr, 0};
  sinew_affine root = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  const unsigned char* out_of_view = nullptr;
  std::uint32_t asleep = 0;
};

struct FirstNeeds {
  std::size_t struct_size = sizeof(FirstNeeds);
  std::uint32_t flags = SINEW_NEED_JOINTS | SINEW_NEED_POSITIONS;
  std::uint32_t max_layers = 2, max_adding_layers = 0, skinning = 0, normal_rule = 0, mask_count = 0;
  const float* masks = nullptr;
  const unsigned char* instance_skinning = nullptr;
};

struct FirstJobsOptions {
  std::size_t struct_size = sizeof(FirstJobsOptions);
  sinew_executor executor = {nullptr, nullptr};
  sinew_allocator allocator = {nullptr, nullptr, nullptr};
  std::size_t inline_below_bytes = 0, part_bytes = 1;
};

struct FirstPageWindow {
  std::size_t struct_size = sizeof(FirstPageWindow);
  std::size_t pages = 3;
  std::uint32_t loops = 0;
};

struct FirstLodInfo {
  std::size_t struct_size = sizeof(FirstLodInfo);
  sinew_flags kept = {nullptr, 0};
  double measured_m = 0.0;
  std::uint32_t left_out = 0, worst_joint = 0;
};

/// A struct as a future version may have it.
struct LaterInput {
  LaterInput() { known.struct_size = sizeof(LaterInput); }
  sinew_frame_input known = sinew_default_input();
  std::uint64_t added[3] = {0, 0, 0};
};

struct LaterOptions {
  LaterOptions() { known.struct_size = sizeof(LaterOptions); }
  sinew_jobs_options known = sinew_default_jobs_options();
  std::uint64_t added = 0;
};

static_assert(sizeof(FirstInput) < sizeof(sinew_frame_input) && sizeof(LaterInput) > sizeof(sinew_frame_input));
static_assert(sizeof(FirstPageWindow) < sizeof(sinew_page_window));
static_assert(sizeof(FirstNeeds) < sizeof(sinew_needs) && sizeof(FirstJobsOptions) < sizeof(sinew_jobs_options));

template <class Known, class Given>
const Known* as(const Given& given) {
  return reinterpret_cast<const Known*>(&given);
}

constexpr std::size_t kCharacters = 4;

class StructVersions : public testing::Test {
 protected:
  StructVersions() : scene{random_scene(6)} {
    EXPECT_EQ(sinew_plan_create(&scene, as<sinew_needs>(FirstNeeds{}), &plan), SINEW_OK);
    for (std::size_t c = 0; c < kCharacters; ++c) layers[c] = {0.2 * static_cast<double>(c), 0, SINEW_NONE, 1.0f, 0};
  }
  ~StructVersions() override {
    sinew_jobs_destroy(jobs);
    sinew_plan_destroy(plan);
  }

  void make_jobs(const sinew_jobs_options* options) {
    ASSERT_EQ(sinew_jobs_create(options, &jobs), SINEW_OK);
    std::uint32_t character = 0;
    for (std::size_t c = 0; c < kCharacters; ++c) ASSERT_EQ(sinew_jobs_add_character(jobs, plan, &character), SINEW_OK);
  }

  /// Expects each character to show the same as its input alone gives.
  template <class Input>
  void expect_frames_of(const Input (&inputs)[kCharacters]) {
    std::uint64_t ticket = 0;
    ASSERT_EQ(sinew_jobs_submit(jobs, as<sinew_frame_input>(inputs[0]), kCharacters, &ticket), SINEW_OK);
    ASSERT_EQ(sinew_jobs_wait(jobs, ticket), SINEW_OK);
    ASSERT_EQ(sinew_jobs_last_error(jobs), SINEW_OK);
    for (std::uint32_t c = 0; c < kCharacters; ++c) {
      sinew_frame_input alone = sinew_default_input();
      alone.layers = &layers[c];
      alone.layer_count = 1;
      alone.root.row[0][3] = static_cast<float>(c);
      Numbers read, expected;
      ASSERT_EQ(engine_read(sinew_jobs_latest(jobs, c), 0, &read), SINEW_OK);
      ASSERT_EQ(engine_play(&scene, as<sinew_needs>(FirstNeeds{}), &alone, nullptr, &expected), SINEW_OK);
      // The plan has no palettes, so reading with zero skins reads everything.
      EXPECT_TRUE(same_bits<float>(read.all(), expected.all())) << "character " << c;
    }
  }

  sinew_scene scene;
  sinew_plan* plan = nullptr;
  sinew_jobs* jobs = nullptr;
  sinew_layer layers[kCharacters];
};

using c_struct_versions = StructVersions;

TEST_F(c_struct_versions, an_array_of_smaller_structs_is_read_in_steps_of_the_callers_size) {
  make_jobs(as<sinew_jobs_options>(FirstJobsOptions{}));
  FirstInput inputs[kCharacters];
  for (std::size_t c = 0; c < kCharacters; ++c) {
    inputs[c].layers = &layers[c];
    inputs[c].layer_count = 1;
    inputs[c].root.row[0][3] = static_cast<float>(c);
  }
  expect_frames_of(inputs);
}

TEST_F(c_struct_versions, an_array_of_larger_structs_is_read_in_steps_of_the_callers_size) {
  make_jobs(as<sinew_jobs_options>(LaterOptions{}));
  LaterInput inputs[kCharacters];
  for (std::size_t c = 0; c < kCharacters; ++c) {
    inputs[c].known.layers = &layers[c];
    inputs[c].known.layer_count = 1;
    inputs[c].known.root.row[0][3] = static_cast<float>(c);
  }
  expect_frames_of(inputs);
  inputs[2].added[1] = 1;
  EXPECT_EQ(sinew_jobs_submit(jobs, &inputs[0].known, kCharacters, nullptr), SINEW_WRONG_STRUCT_SIZE)
      << "something that this library does not know";
  inputs[2].added[1] = 0;
  inputs[3].known.struct_size = sizeof(sinew_frame_input);
  EXPECT_EQ(sinew_jobs_submit(jobs, &inputs[0].known, kCharacters, nullptr), SINEW_WRONG_STRUCT_SIZE)
      << "elements of one array are of one version";
}

TEST_F(c_struct_versions, what_an_older_caller_lacks_has_its_default) {
  sinew_frame* frame = nullptr;
  ASSERT_EQ(sinew_frame_create(plan, nullptr, &frame), SINEW_OK);
  // The memory behind the older struct would give an interpolation factor and layers, if the library read it.
  struct {
    FirstInput input;
    double behind[8] = {1e300, -1e300, 1e300, 1e300, 1e300, 1e300, 1e300, 1e300};
  } older;
  EXPECT_EQ(sinew_run(frame, as<sinew_frame_input>(older.input)), SINEW_OK);
  older.input.struct_size = sizeof(FirstInput) - 8;
  EXPECT_EQ(sinew_run(frame, as<sinew_frame_input>(older.input)), SINEW_WRONG_STRUCT_SIZE) << "older than the first";
  older.input.struct_size = 0;
  EXPECT_EQ(sinew_run(frame, as<sinew_frame_input>(older.input)), SINEW_WRONG_STRUCT_SIZE);
  sinew_frame_destroy(frame);
}

TEST_F(c_struct_versions, an_older_caller_is_answered_as_much_as_it_knows) {
  sinew_held_input* held = nullptr;
  ASSERT_EQ(sinew_held_input_create(plan, &held), SINEW_OK);
  struct {
    FirstInput input;
    unsigned char behind[32];
  } older;
  std::memset(older.behind, 0xa5, sizeof(older.behind));
  auto* out = reinterpret_cast<sinew_frame_input*>(&older.input);
  ASSERT_EQ(sinew_held_input_next(held, nullptr, SINEW_UPDATE_EVERY, 0, 0, out), SINEW_OK);
  EXPECT_EQ(older.input.struct_size, sizeof(FirstInput));
  for (const unsigned char byte : older.behind) EXPECT_EQ(byte, 0xa5);
  sinew_held_input_destroy(held);
}

TEST_F(StructVersions, skeleton_lods_tell_the_first_version_what_it_knows) {
  sinew_skeleton_lod* lod = nullptr;
  ASSERT_EQ(sinew_skeleton_lod_create(&scene, 1e9, nullptr, 0, nullptr, &lod), SINEW_OK);
  struct {
    FirstLodInfo info;
    double behind = -7.0;
  } engine;
  ASSERT_EQ(sinew_get_skeleton_lod(lod, reinterpret_cast<sinew_skeleton_lod_info*>(&engine.info)), SINEW_OK);
  EXPECT_GT(engine.info.left_out, 0u);
  EXPECT_EQ(engine.behind, -7.0) << "it is not written beyond its end";
  sinew_skeleton_lod_destroy(lod);
}

TEST_F(StructVersions, page_windows_of_the_first_version_are_for_all_joints) {
  struct {
    FirstPageWindow window;
    const void* behind = "not a plan";
  } engine;
  sinew_paged_clip* paged = nullptr;
  sinew_page* page = nullptr;
  ASSERT_EQ(sinew_paged_clip_create(&scene, 0, 0.1, 9, as<sinew_page_window>(engine.window), &paged), SINEW_OK);
  ASSERT_EQ(sinew_page_create(&page), SINEW_OK);
  ASSERT_EQ(sinew_paged_clip_at(paged, 0.0, 0, page), SINEW_OK);
  EXPECT_EQ(page->sample.page.joint_count(), scene.scene.skeleton.joint_count());
  sinew_page_destroy(page);
  sinew_paged_clip_destroy(paged);
}

}  // namespace
}  // namespace sinew::test
