// SPDX-License-Identifier: MIT
#include "viewer/app/headless.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/viewer/device_fixture.h"
#include "viewer/app/clip_extent.h"
#include "viewer/app/pictures/png_writer.h"

namespace sinew::viewer {
namespace {

class headless : public DeviceTest {};
class frame_upload : public DeviceTest {};

View side_view() { return look_at({1.0, 0.6, 4.0}, {1.0, 0.4, 0.0}, 0.8, 0.05); }

TEST_F(headless, N34_two_renderers_give_the_same_bytes) {
  const BuiltScene built = box_and_sphere_on_floor();
  const View view = look_at({2.5, 2.2, 4.0}, {0.0, 0.4, 0.0}, 0.8, 0.05);
  Headless one(*test_device(), built.scene, 160, 90), other(*test_device(), built.scene, 160, 90);
  const Picture first = one.render(built.frame(), view, {});
  EXPECT_EQ(first.rgba, one.render(built.frame(), view, {}).rgba);
  EXPECT_EQ(first.rgba, other.render(built.frame(), view, {}).rgba);
  EXPECT_EQ(first.rgba.size(), 160u * 90u * 4u);
}

TEST_F(headless, a_deformed_arm_moves_and_every_frame_stands_for_itself) {
  const BuiltScene straight = bent_arm(0.0f), bent = bent_arm(1.2f);
  Headless renderer(*test_device(), bent.scene, 96, 64);
  RenderOptions options;
  options.transparent_background = true;
  const Picture a = renderer.render(straight.frame(), side_view(), options);
  const Picture b = renderer.render(bent.frame(), side_view(), options);
  EXPECT_NE(a.rgba, b.rgba);
  EXPECT_EQ(a.rgba, renderer.render(straight.frame(), side_view(), options).rgba);
  const auto alpha = [](const Picture& p, std::uint32_t x, std::uint32_t y) {
    return p.rgba[4 * (y * p.width + x) + 3];
  };
  EXPECT_EQ(alpha(a, 54, 24), 0);  // only the bent forearm covers this pixel
  EXPECT_EQ(alpha(b, 54, 24), 255);
}

TEST_F(headless, settings_can_change_between_frames_of_one_renderer) {
  const BuiltScene built = box_and_sphere_on_floor();
  const View view = look_at({2.5, 2.2, 4.0}, {0.0, 0.4, 0.0}, 0.8, 0.05);
  Headless renderer(*test_device(), built.scene, 64, 48);
  RenderOptions with, without;
  without.ao.on = false;
  const Picture first = renderer.render(built.frame(), view, with);
  const Picture plain = renderer.render(built.frame(), view, without);
  EXPECT_NE(first.rgba, plain.rgba);
  EXPECT_EQ(first.rgba, renderer.render(built.frame(), view, with).rgba);
}

TEST_F(headless, reports_a_time_for_every_pass_it_ran) {
  const BuiltScene built = box_and_sphere_on_floor();
  Headless renderer(*test_device(), built.scene, 64, 48);
  RenderOptions options;
  options.ao.on = false;
  renderer.render(built.frame(), side_view(), options);
  const auto times = renderer.pass_times();
  if (test_device()->timestamp_bits() == 0) GTEST_SKIP() << "this queue has no timestamps";
  ASSERT_EQ(times.size(), 2u);
  EXPECT_EQ(times[0].pass, "opaque");
  EXPECT_EQ(times[1].pass, "tonemap");
  for (const PassTime& time : times) EXPECT_GE(time.milliseconds, 0.0);
}

TEST_F(frame_upload, copies_nothing_for_a_rigid_scene_and_nothing_twice_for_an_animated_one) {
  const BuiltScene rigid = box_and_sphere_on_floor();
  FrameUpload still(*test_device(), rigid.scene, 2);
  for (std::uint64_t number = 1; number < 4; ++number) still.update(0, rigid.frame(number));
  EXPECT_EQ(still.uploaded_bytes(), 0u);

  const BuiltScene arm = bent_arm(0.5f);
  FrameUpload moving(*test_device(), arm.scene, 2);
  moving.update(0, arm.frame(1));
  const std::uint64_t once = moving.uploaded_bytes();
  EXPECT_EQ(once, 2 * sizeof(glm::vec3) * arm.scene.meshes[0].primitives[0].vertex_count());
  moving.update(0, arm.frame(1));
  EXPECT_EQ(moving.uploaded_bytes(), once);
  moving.update(1, arm.frame(1));  // the other slot has not seen it yet
  moving.update(0, arm.frame(2));
  moving.update(0, arm.frame(2), 7);  // the same number from another source
  EXPECT_EQ(moving.uploaded_bytes(), 4 * once);
}

TEST_F(frame_upload, P19_copies_no_primitive_that_the_slot_has_already) {
  const BuiltScene arm = bent_arm(0.5f), other_arm = bent_arm(0.9f);
  FrameUpload upload(*test_device(), arm.scene, 1);
  const auto frame = [](const BuiltScene& built, std::uint64_t number, std::uint64_t since,
                        std::vector<DeformedPrimitive>& room) {
    FrameResult result = built.frame(number);
    room.assign(result.primitives.begin(), result.primitives.end());
    room[0].since_frame = since;
    result.primitives = room;
    return result;
  };
  std::vector<DeformedPrimitive> room;
  upload.update(0, frame(arm, 3, 3, room));
  const std::uint64_t once = upload.uploaded_bytes();
  upload.update(0, frame(arm, 5, 2, room));
  EXPECT_EQ(upload.uploaded_bytes(), once) << "frame 3 was one of the row from 2 to 5";
  EXPECT_EQ(upload.last_update().unchanged, 1u);
  upload.update(0, frame(other_arm, 6, 6, room));
  EXPECT_EQ(upload.uploaded_bytes(), 2 * once);
  EXPECT_EQ(upload.last_update().written, 1u);
  const std::byte* there = upload.vertices(0).buffer.mapped();
  EXPECT_EQ(0, std::memcmp(there, room[0].positions.data(), room[0].positions.size_bytes()));
  upload.update(0, frame(other_arm, 7, 6, room), 1);
  EXPECT_EQ(upload.uploaded_bytes(), 3 * once) << "stamps of another source say nothing";
  upload.update(0, frame(other_arm, 8, 0, room), 1);
  EXPECT_EQ(upload.uploaded_bytes(), 4 * once) << "no stamp";
}

TEST_F(frame_upload, keeps_its_buffer_when_the_next_frame_is_no_larger) {
  const BuiltScene arm = bent_arm(0.5f);
  FrameUpload upload(*test_device(), arm.scene, 1);
  upload.update(0, arm.frame(1));
  const VkBuffer buffer = upload.vertices(0).buffer.handle();
  upload.update(0, arm.frame(2));
  EXPECT_EQ(upload.vertices(0).buffer.handle(), buffer);
}

TEST(scene_bounds, are_those_of_the_deformed_vertices) {
  const BuiltScene straight = bent_arm(0.0f), bent = bent_arm(1.5707963f);
  EXPECT_LT(bounds_of(straight.scene, straight.frame()).upper.y, 0.3f);
  EXPECT_NEAR(bounds_of(bent.scene, bent.frame()).upper.y, 1.0f, 1e-3f);
}

TEST(device, a_machine_without_any_driver_is_a_clean_error) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");  // a forked process of a driver with threads would hang
  EXPECT_EXIT(
      {
        setenv("VK_ICD_FILENAMES", "/nonexistent/icd.json", 1);
        setenv("VK_DRIVER_FILES", "/nonexistent/icd.json", 1);
        try {
          const Device device;
        } catch (const DeviceError& error) {
          std::fprintf(stderr, "%s\n", error.what());
          std::exit(3);
        }
        std::exit(0);
      },
      testing::ExitedWithCode(3), "Vulkan: ");
}

TEST_F(headless, memory_goes_back_block_by_block) {
  const std::size_t before = test_device()->memory().block_count();
  const BuiltScene built = box_and_sphere_on_floor();
  {
    Headless renderer(*test_device(), built.scene, 640, 480);
    renderer.render(built.frame(), side_view(), {});
    EXPECT_GT(test_device()->memory().block_count(), before);
  }
  EXPECT_EQ(test_device()->memory().block_count(), before);
}

TEST(png_writer, writes_what_another_program_reads_and_names_files_that_it_cannot_write) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("sinew-png-writer-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  Picture picture{2, 1, {255, 0, 0, 255, 0, 0, 255, 0}};
  PngWriter writer;
  for (int i = 0; i < 8; ++i) writer.write(folder / (std::to_string(i) + ".png"), picture);
  writer.write(folder / "no-such-folder" / "x.png", picture);
  writer.write(folder / "wrong.png", {3, 3, {1, 2, 3}});
  const std::vector<std::string> failures = writer.finish();
  ASSERT_EQ(failures.size(), 2u);
  EXPECT_NE(failures[0].find("no-such-folder"), std::string::npos);
  for (int i = 0; i < 8; ++i) {
    std::ifstream in(folder / (std::to_string(i) + ".png"), std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(in)), {});
    EXPECT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n");
    EXPECT_EQ(bytes.substr(12, 14), std::string("IHDR\0\0\0\2\0\0\0\1\x08\x06", 14));
  }
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace sinew::viewer
