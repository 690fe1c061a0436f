// SPDX-License-Identifier: MIT
// Long clips give the same frames in pages as whole, through the C interface.
#include "tests/c/engine_pages.h"

#include <gtest/gtest.h>
#include <zstd.h>

#include <array>
#include <cmath>
#include <string>

#include "runtime/asset_file/write_asset_file.h"
#include "runtime/base/same_bits.h"
#include "runtime/c/handles.h"
#include "runtime/c_assets/sinew_assets.h"
#include "tests/c/numbers.h"
#include "tests/paging/pages.h"
#include "tests/scenes/random_scene.h"

namespace sinew::test {
namespace {

constexpr double kPage_s = 0.3, kFrame_s = 0.031;
constexpr int kFrames = 70;

const unsigned char* begin_of(const std::vector<std::byte>& bytes) {
  return reinterpret_cast<const unsigned char*>(bytes.data());
}

TEST(c_pages, an_engine_in_c_plays_pages_of_a_file_with_the_bits_of_whole_clips) {
  for (const int zstd_level : {0, 5}) {
    const Scene scene = random_scene(3);
    const std::vector<std::byte> file = write_asset_file(scene, {.page_s = kPage_s, .zstd_level = zstd_level});
    std::size_t missing = 0, most_pages = 0;
    Numbers paged, whole;
    ASSERT_EQ(engine_play_pages(begin_of(file), file.size(), 1, kFrame_s, kFrames, 1, &missing, &most_pages, &paged),
              SINEW_OK);
    EXPECT_EQ(missing, 0u);
    EXPECT_EQ(most_pages, 4u);
    const sinew_scene in_c{scene};
    for (int i = 0; i < kFrames; ++i) {
      const sinew_layer layer{i * kFrame_s, 1, SINEW_NONE, 1.0f, SINEW_LAYER_BLEND};
      sinew_frame_input input = sinew_default_input();
      input.layers = &layer;
      input.layer_count = 1;
      ASSERT_EQ(engine_play(&in_c, nullptr, &input, nullptr, &whole), SINEW_OK);
    }
    EXPECT_EQ(paged.all().size(), whole.all().size());
    EXPECT_TRUE(same_bits<float>(paged.all(), whole.all()));
  }
}

TEST(c_pages, without_a_page_the_start_is_shown_and_told) {
  const Scene scene = random_scene(3);
  const std::vector<std::byte> file = write_asset_file(scene, {.page_s = kPage_s});
  std::size_t missing = 0, most_pages = 0;
  Numbers shown;
  ASSERT_EQ(engine_play_pages(begin_of(file), file.size(), 0, kFrame_s, 10, 0, &missing, &most_pages, &shown),
            SINEW_OK);
  EXPECT_EQ(missing, 10u);
  EXPECT_EQ(most_pages, 0u);
}

struct CPages : testing::Test {
  CPages() {
    EXPECT_EQ(sinew_paged_clip_create(&heads, 0, kPage_s, bytes.size(), nullptr, &paged), SINEW_OK);
    EXPECT_EQ(sinew_page_create(&page), SINEW_OK);
  }
  ~CPages() override {
    sinew_paged_clip_destroy(paged);
    sinew_page_destroy(page);
  }
  static Scene heads_of(Scene scene) {
    for (Clip& clip : scene.clips) clip = first_keys(clip);
    return scene;
  }

  const Scene scene = random_scene(3);
  const sinew_scene heads{heads_of(scene)};
  const std::vector<std::vector<std::byte>> bytes = pages_of(scene.clips[0], kPage_s);
  sinew_paged_clip* paged = nullptr;
  sinew_page* page = nullptr;
};

TEST_F(CPages, what_cannot_be_is_refused) {
  sinew_paged_clip* none = nullptr;
  const auto create = [&](std::uint32_t clip, double page_s, std::size_t count, const sinew_page_window* window) {
    return sinew_paged_clip_create(&heads, clip, page_s, count, window, &none);
  };
  const auto clips = static_cast<std::uint32_t>(scene.clips.size());
  EXPECT_EQ(create(clips, 1.0, 3, nullptr), SINEW_INDEX_OUT_OF_RANGE);
  EXPECT_EQ(create(clips + 1, 1.0, 3, nullptr), SINEW_INDEX_OUT_OF_RANGE);
  for (const double page_s : {0.0, -1.0, std::nan(""), HUGE_VAL})
    EXPECT_EQ(create(0, page_s, 3, nullptr), SINEW_UNSUPPORTED);
  EXPECT_EQ(create(0, 1.0, 0, nullptr), SINEW_UNSUPPORTED);
  sinew_page_window window = sinew_default_page_window();
  EXPECT_EQ(window.pages, 4u);
  EXPECT_EQ(window.loops, 1u);
  window.pages = 1;
  EXPECT_EQ(create(0, 1.0, 3, &window), SINEW_UNSUPPORTED);
  window.struct_size = 4;
  EXPECT_EQ(create(0, 1.0, 3, &window), SINEW_WRONG_STRUCT_SIZE);
  EXPECT_EQ(none, nullptr);
  EXPECT_EQ(sinew_paged_clip_create(nullptr, 0, 1.0, 3, nullptr, &none), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_paged_clip_create(&heads, 0, 1.0, 3, nullptr, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_page_create(nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_paged_clip_at(paged, std::nan(""), 0, page), SINEW_NOT_FINITE);
  EXPECT_EQ(sinew_paged_clip_at(nullptr, 0.0, 0, page), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_paged_clip_at(paged, 0.0, 0, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_paged_clip_next_page(nullptr, nullptr), 0);
  EXPECT_EQ(sinew_paged_clip_loaded_pages(nullptr), 0u);
  EXPECT_EQ(sinew_paged_clip_loaded_bytes(nullptr), 0u);
  EXPECT_EQ(sinew_page_time_s(nullptr), 0.0);
  EXPECT_EQ(sinew_page_is_missing(nullptr), 1);
  sinew_paged_clip_destroy(nullptr);
  sinew_page_destroy(nullptr);
}

TEST_F(CPages, bytes_are_taken_left_or_refused_in_words) {
  ASSERT_EQ(sinew_paged_clip_at(paged, 0.1, 0, page), SINEW_OK);
  const auto load = [&](std::size_t number, const std::vector<std::byte>& block, int* taken, sinew_messages** why) {
    return sinew_paged_clip_load_page(paged, number, block.data(), block.size(), taken, why);
  };
  int taken = -1;
  EXPECT_EQ(load(4, bytes[4], &taken, nullptr), SINEW_OK);
  EXPECT_EQ(taken, 0) << "the window does not have it";
  EXPECT_EQ(load(0, bytes[0], &taken, nullptr), SINEW_OK);
  EXPECT_EQ(taken, 1);
  EXPECT_EQ(sinew_paged_clip_loaded_pages(paged), 1u);
  EXPECT_GT(sinew_paged_clip_loaded_bytes(paged), 0u);
  sinew_messages* why = nullptr;
  EXPECT_EQ(load(1, bytes[2], nullptr, &why), SINEW_BAD_FILE);
  ASSERT_EQ(sinew_message_count(why), 1u);
  EXPECT_NE(std::string(sinew_message(why, 0)).find("clip-page: the block is not page"), std::string::npos);
  sinew_messages_destroy(why);
  EXPECT_EQ(load(1, bytes[2], nullptr, nullptr), SINEW_BAD_FILE);
  EXPECT_EQ(load(bytes.size(), bytes[0], nullptr, nullptr), SINEW_INDEX_OUT_OF_RANGE);
  EXPECT_EQ(sinew_paged_clip_load_page(paged, 0, nullptr, 4, nullptr, nullptr), SINEW_NULL_ARGUMENT);
}

TEST_F(CPages, pages_for_a_plan_with_a_skeleton_lod_have_its_joints) {
  sinew_skeleton_lod* lod = nullptr;
  ASSERT_EQ(sinew_skeleton_lod_create(&heads, 1e6, nullptr, 0, nullptr, &lod), SINEW_OK);
  sinew_needs needs = sinew_default_needs();
  needs.skeleton_lod = lod;
  sinew_plan* plan = nullptr;
  ASSERT_EQ(sinew_plan_create(&heads, &needs, &plan), SINEW_OK);
  sinew_page_window window = sinew_default_page_window();
  EXPECT_EQ(window.plan, nullptr);
  window.plan = plan;
  const sinew_scene other{scene};
  sinew_paged_clip* reduced = nullptr;
  EXPECT_EQ(sinew_paged_clip_create(&other, 0, kPage_s, bytes.size(), &window, &reduced), SINEW_SIZE_MISMATCH);
  ASSERT_EQ(sinew_paged_clip_create(&heads, 0, kPage_s, bytes.size(), &window, &reduced), SINEW_OK);
  sinew_frame* frame = nullptr;
  ASSERT_EQ(sinew_frame_create(plan, nullptr, &frame), SINEW_OK);
  const sinew_layer layer{0.1, 0, SINEW_NONE, 1.0f, SINEW_LAYER_BLEND};
  const sinew_page* const pages[] = {page};
  sinew_frame_input input = sinew_default_input();
  input.layers = &layer;
  input.layer_count = 1;
  input.pages = pages;
  ASSERT_EQ(sinew_paged_clip_at(paged, 0.1, 0, page), SINEW_OK);
  EXPECT_EQ(sinew_run(frame, &input), SINEW_WRONG_PAGE) << "a page of all joints";
  ASSERT_EQ(sinew_paged_clip_at(reduced, 0.1, 0, page), SINEW_OK);
  EXPECT_EQ(sinew_run(frame, &input), SINEW_OK) << "the start, while no page is there";
  ASSERT_EQ(sinew_assets_load_page(reduced, 0, bytes[0].data(), bytes[0].size(), nullptr, nullptr), SINEW_OK);
  ASSERT_EQ(sinew_paged_clip_at(reduced, 0.1, 0, page), SINEW_OK);
  EXPECT_EQ(sinew_page_is_missing(page), 0);
  EXPECT_EQ(sinew_run(frame, &input), SINEW_OK);
  sinew_frame_destroy(frame);
  sinew_paged_clip_destroy(reduced);
  sinew_plan_destroy(plan);
  sinew_skeleton_lod_destroy(lod);
}

TEST_F(CPages, a_page_of_a_file_that_does_not_unpack_is_refused_in_words) {
  std::vector<std::byte> packed(ZSTD_compressBound(bytes[0].size()));
  packed.resize(ZSTD_compress(packed.data(), packed.size(), bytes[0].data(), bytes[0].size(), 3));
  ASSERT_EQ(sinew_paged_clip_at(paged, 0.1, 0, page), SINEW_OK);
  int taken = 0;
  sinew_messages* why = nullptr;
  EXPECT_EQ(sinew_assets_load_page(paged, 0, packed.data(), packed.size() - 1, &taken, &why), SINEW_BAD_FILE);
  ASSERT_EQ(sinew_message_count(why), 1u);
  EXPECT_NE(std::string(sinew_message(why, 0)).find("asset-size in block page_keys"), std::string::npos);
  sinew_messages_destroy(why);
  EXPECT_EQ(sinew_assets_load_page(paged, 0, packed.data(), packed.size(), &taken, nullptr), SINEW_OK);
  EXPECT_EQ(taken, 1);
  EXPECT_EQ(sinew_assets_load_page(nullptr, 0, packed.data(), packed.size(), &taken, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_assets_load_page(paged, 0, nullptr, 0, &taken, nullptr), SINEW_NULL_ARGUMENT);
}

TEST_F(CPages, held_inputs_keep_the_pages_of_their_layers_and_interpolated_ones_refuse_them) {
  sinew_needs needs = sinew_default_needs();
  needs.flags |= SINEW_NEED_BETWEEN_UPDATES;
  sinew_plan* plan = nullptr;
  ASSERT_EQ(sinew_plan_create(&heads, &needs, &plan), SINEW_OK);
  ASSERT_EQ(sinew_paged_clip_at(paged, 0.1, 0, page), SINEW_OK);
  const sinew_layer layers[] = {{0.1, 1, SINEW_NONE, 0.5f, SINEW_LAYER_BLEND},
                                {0.1, 0, SINEW_NONE, 0.5f, SINEW_LAYER_BLEND}};
  const sinew_page* const pages[] = {nullptr, page};
  sinew_frame_input input = sinew_default_input(), out = sinew_default_input();
  input.layers = layers;
  input.layer_count = 2;
  sinew_held_input* held = nullptr;
  ASSERT_EQ(sinew_held_input_create(plan, &held), SINEW_OK);
  ASSERT_EQ(sinew_held_input_next(held, &input, SINEW_UPDATE_EVERY, 0, 0, &out), SINEW_OK);
  EXPECT_EQ(out.pages, nullptr);
  input.pages = pages;
  ASSERT_EQ(sinew_held_input_next(held, &input, SINEW_UPDATE_EVERY, 0, 0, &out), SINEW_OK);
  ASSERT_NE(out.pages, nullptr);
  EXPECT_EQ(out.pages[0], nullptr);
  EXPECT_EQ(out.pages[1], page);
  const sinew_layer turned[] = {layers[1], layers[0]};
  const sinew_page* const first[] = {page, nullptr};
  input.layers = turned;
  input.pages = first;
  ASSERT_EQ(sinew_held_input_next(held, &input, SINEW_UPDATE_EVERY, 0, 0, &out), SINEW_OK);
  ASSERT_NE(out.pages, nullptr);
  EXPECT_EQ(out.pages[0], page);
  EXPECT_EQ(out.pages[1], nullptr);
  sinew_held_input_destroy(held);
  sinew_interpolated_input* interpolated = nullptr;
  ASSERT_EQ(sinew_interpolated_input_create(plan, &interpolated), SINEW_OK);
  EXPECT_EQ(sinew_interpolated_input_next(interpolated, &input, layers, 2, SINEW_UPDATE_EVERY_SECOND, 0, 0, &out),
            SINEW_UNSUPPORTED);
  sinew_interpolated_input_destroy(interpolated);
  sinew_plan_destroy(plan);
}

TEST_F(CPages, held_inputs_keep_the_pages_of_next_layers) {
  sinew_needs needs = sinew_default_needs();
  needs.flags |= SINEW_NEED_BETWEEN_UPDATES;
  sinew_plan* plan = nullptr;
  ASSERT_EQ(sinew_plan_create(&heads, &needs, &plan), SINEW_OK);
  ASSERT_EQ(sinew_paged_clip_at(paged, 0.1, 0, page), SINEW_OK);
  const sinew_layer now[] = {{0.1, 0, SINEW_NONE, 1.0f, SINEW_LAYER_BLEND}},
                    next[] = {{0.2, 1, SINEW_NONE, 0.5f, SINEW_LAYER_BLEND}, {0.3, 0, SINEW_NONE, 0.5f, 0}};
  const sinew_page* const pages[] = {page, nullptr, page};
  sinew_frame_input input = sinew_default_input(), out = sinew_default_input();
  input.layers = now;
  input.layer_count = 1;
  input.next_layers = next;
  input.next_layer_count = 2;
  input.pages = pages;
  input.next_pages = pages + 1;
  input.interpolation_factor = 0.5f;
  sinew_held_input* held = nullptr;
  ASSERT_EQ(sinew_held_input_create(plan, &held), SINEW_OK);
  for (const std::uint64_t frame : {0u, 1u}) {
    ASSERT_EQ(sinew_held_input_next(held, &input, SINEW_UPDATE_EVERY_SECOND, frame, 0, &out), SINEW_OK);
    ASSERT_TRUE(out.pages != nullptr && out.next_pages != nullptr);
    EXPECT_EQ(out.pages[0], page) << "both lists are there at once";
    EXPECT_EQ(out.next_pages[0], nullptr);
    EXPECT_EQ(out.next_pages[1], page);
    EXPECT_EQ(out.layers[0].time_s, 0.1);
    EXPECT_EQ(out.next_layers[1].time_s, 0.3);
  }
  sinew_held_input_destroy(held);
  sinew_plan_destroy(plan);
}

/// Two layers and two next layers play one clip at four times, so that each needs a page of its own.
TEST_F(CPages, next_layers_play_their_own_pages) {
  std::array<sinew_page*, 4> at{};
  std::array<sinew_layer, 4> in_pages{}, in_whole{};
  for (std::size_t i = 0; i < 4; ++i) {
    const double time_s = 0.1 + 0.35 * static_cast<double>(i);
    ASSERT_EQ(sinew_page_create(&at[i]), SINEW_OK);
    ASSERT_EQ(sinew_paged_clip_at(paged, time_s, 0, at[i]), SINEW_OK);
    for (std::size_t number = 0; sinew_paged_clip_next_page(paged, &number) != 0;)
      ASSERT_EQ(sinew_paged_clip_load_page(paged, number, bytes[number].data(), bytes[number].size(), nullptr, nullptr),
                SINEW_OK);
    ASSERT_EQ(sinew_paged_clip_at(paged, time_s, 0, at[i]), SINEW_OK);
    EXPECT_EQ(sinew_page_is_missing(at[i]), 0);
    in_pages[i] = {sinew_page_time_s(at[i]), 0, SINEW_NONE, 0.5f, SINEW_LAYER_BLEND};
    in_whole[i] = in_pages[i];
    in_whole[i].time_s = time_s;
  }
  sinew_needs needs = sinew_default_needs();
  needs.flags |= SINEW_NEED_BETWEEN_UPDATES;
  needs.max_layers = 2;
  const sinew_scene all{scene};
  const auto play = [&](const sinew_scene& shown, const std::array<sinew_layer, 4>& layers, sinew_page** pages) {
    sinew_frame_input input = sinew_default_input();
    input.layers = &layers[0];
    input.next_layers = &layers[2];
    input.layer_count = input.next_layer_count = 2;
    input.interpolation_factor = 0.25f;
    input.pages = pages;
    input.next_pages = pages == nullptr ? nullptr : pages + 2;
    Numbers numbers;
    EXPECT_EQ(engine_play(&shown, &needs, &input, nullptr, &numbers), SINEW_OK);
    return numbers.all();
  };
  EXPECT_TRUE(same_bits<float>(play(heads, in_pages, at.data()), play(all, in_whole, nullptr)));
  for (sinew_page* one : at) sinew_page_destroy(one);
}

TEST(c_pages, tables_of_files_say_where_pages_lie) {
  const Scene scene = random_scene(3);
  const std::vector<std::byte> file = write_asset_file(scene, {.page_s = kPage_s}), whole = write_asset_file(scene);
  sinew_scene* heads = nullptr;
  sinew_page_tables* tables = nullptr;
  ASSERT_EQ(sinew_assets_read_first_keys(file.data(), file.size(), &heads, &tables, nullptr), SINEW_OK);
  double page_s = 0.0;
  EXPECT_EQ(sinew_page_tables_count(tables, 0, &page_s), page_count_of(scene.clips[0].duration_s(), kPage_s));
  EXPECT_EQ(page_s, kPage_s);
  const auto pages = pages_of(scene.clips[0], kPage_s);
  for (std::size_t p = 0; p < pages.size(); ++p) {
    std::uint64_t offset = 0;
    ASSERT_EQ(sinew_page_tables_place(tables, 0, p, &offset), pages[p].size());
    EXPECT_TRUE(same_bits<std::byte>(pages[p], std::span(file).subspan(offset, pages[p].size())));
  }
  EXPECT_EQ(sinew_page_tables_place(tables, 0, pages.size(), nullptr), 0u);
  EXPECT_EQ(sinew_page_tables_count(tables, 7, &page_s), 0u);
  EXPECT_EQ(page_s, 0.0);
  sinew_page_tables_destroy(tables);
  sinew_scene_destroy(heads);
  ASSERT_EQ(sinew_assets_read_first_keys(whole.data(), whole.size(), &heads, &tables, nullptr), SINEW_OK);
  EXPECT_EQ(sinew_page_tables_count(tables, 0, nullptr), 0u);
  sinew_page_tables_destroy(tables);
  sinew_page_tables_destroy(nullptr);
  sinew_scene_destroy(heads);
  EXPECT_EQ(sinew_assets_read_first_keys(file.data(), 9, &heads, &tables, nullptr), SINEW_BAD_FILE);
  EXPECT_EQ(sinew_assets_read_first_keys(file.data(), file.size(), &heads, nullptr, nullptr), SINEW_NULL_ARGUMENT);
}

}  // namespace
}  // namespace sinew::test
