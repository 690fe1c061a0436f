// SPDX-License-Identifier: MIT
// Sequences of pictures: each equals the single picture of its time, independent of earlier pictures.
#include "tests/viewer/cache_scene.h"
#include "tests/viewer/headless_run_fixture.h"

namespace sinew::viewer {
namespace {

class headless_sequence : public HeadlessRunTest {
 protected:
  static fs::path picture_in(const fs::path& folder, std::uint32_t number) {
    return folder / ("0000" + std::to_string(number) + ".png");
  }
  /// The pictures that the program writes; plan_ gets the live plan of the last one.
  std::vector<std::string> sequence(Options options, const LoadedScene& loaded, std::uint32_t clip = 0) {
    options.headless = (folder_ / "new" / std::to_string(++sequences_)).string();
    options.plan = true;
    testing::internal::CaptureStdout();
    EXPECT_EQ(write_pictures(*test_device(), options, loaded, clip), 0);
    plan_ = testing::internal::GetCapturedStdout();
    std::vector<std::string> pictures;
    for (std::uint32_t n = options.frames->first; n <= options.frames->last; ++n)
      pictures.push_back(test::text_of_file(picture_in(options.headless, n)));
    EXPECT_EQ(static_cast<std::size_t>(std::distance(fs::directory_iterator(options.headless), {})), pictures.size());
    return pictures;
  }
  /// The same pictures, each written by itself.
  std::vector<std::string> alone(Options options, const LoadedScene& loaded, double duration_s,
                                 std::uint32_t clip = 0) {
    const auto [first, last] = *options.frames;
    options.frames.reset();
    options.updates.reset();
    std::vector<std::string> pictures;
    for (std::uint32_t n = first; n <= last; ++n) {
      options.time_s = picture_time_s(n, options.fps, duration_s);
      pictures.push_back(written(options, loaded, clip));
    }
    return pictures;
  }
  bool plan_says(const char* words) const { return plan_.find(words) != std::string::npos; }

  std::string plan_;
  int sequences_ = 0;
};

/// From so far away that poses are evaluated less often, but motion is still visible.
Options far_away(Updates updates) {
  Options options = small_picture();
  options.updates = updates;
  options.camera = PlacedCamera{{0, 0, 70}, {0, 0, 0}};
  options.fov_y_deg = 10.0;
  options.width = 192;
  options.height = 128;
  options.smooth_edges = true;
  options.fps = 25.0;
  return options;
}

TEST_F(headless_sequence, is_numbered_and_each_picture_is_that_of_its_time) {
  const LoadedScene loaded = gliding_box();
  Options options = small_picture();
  options.frames = FrameRange{3, 7};
  options.fps = 4.0;
  EXPECT_EQ(sequence(options, loaded), alone(options, loaded, kDuration_s));
  options.framing = Framing::pose;  // that of the first picture
  options.frames = FrameRange{4, 4};
  EXPECT_EQ(sequence(options, loaded), alone(options, loaded, kDuration_s));
}

TEST_F(headless_sequence, small_meshes_are_held_between_updates_only_where_pictures_are_near_in_time) {
  Options options = far_away(Updates::held);
  options.frames = FrameRange{0, 5};
  for (const double fps : {25.0, 5.0}) {
    options.fps = fps;
    const std::vector<std::string> pictures = sequence(options, gliding_box());
    int held = 0;
    for (std::size_t n = 0; n < 5; ++n) held += pictures[n] == pictures[n + 1];
    EXPECT_EQ(held > 0, fps > 20.0) << fps;
    EXPECT_LT(held, 4) << fps;
  }
}

TEST_F(headless_sequence, small_meshes_that_move_evenly_are_interpolated_to_where_they_are) {
  Options options = far_away(Updates::interpolated);
  options.frames = FrameRange{0, 8};
  EXPECT_EQ(sequence(options, gliding_box()), alone(options, gliding_box(), kDuration_s));
  EXPECT_TRUE(plan_says("interpolated in between")) << plan_;
}

TEST_F(headless_sequence, small_meshes_are_not_held_while_the_camera_moves) {
  Options options = far_away(Updates::held);
  options.camera.reset();
  options.fov_y_deg.reset();
  options.file_camera = "far";
  options.frames = FrameRange{0, 4};
  EXPECT_EQ(sequence(options, gliding_box()), alone(options, gliding_box(), kDuration_s));
  EXPECT_TRUE(plan_says("every frame: the camera moves with the clip")) << plan_;
}

TEST_F(headless_sequence, a_geometry_cache_is_shown_wherever_it_goes_and_begins_again_after_its_end) {
  const Bytes bytes = gliding_cache();
  const LoadedScene loaded = scene_of_cache_file(bytes);
  Options options = small_picture();
  options.camera = PlacedCamera{{4.5f, 0.5f, 1.6f}, {4.5f, 0.5f, 0.0f}};  // sees the end alone
  options.fps = 10.0;
  options.frames = FrameRange{4, 7};
  const std::vector<std::string> pictures = sequence(options, loaded, kNone);
  EXPECT_EQ(pictures, alone(options, loaded, loaded.cache->duration_s(), kNone));
  EXPECT_NE(pictures[2], pictures[3]) << "it is there, and then at its start again";
}

TEST_F(headless_sequence, a_geometry_cache_is_framed_where_it_is_at_the_time) {
  const Bytes bytes = gliding_cache();
  const LoadedScene loaded = scene_of_cache_file(bytes);
  Options options = small_picture();
  options.transparent = true;
  options.camera = PlacedCamera{{0, 0, 9}, {0, 0, 90}};
  const std::string nothing = written(options, loaded, kNone);
  options.camera.reset();
  for (const Framing framing : {Framing::pose, Framing::follow})
    for (const double time_s : {0.0, loaded.cache->duration_s()}) {
      options.framing = framing;
      options.time_s = time_s;
      EXPECT_NE(written(options, loaded, kNone), nothing) << static_cast<int>(framing) << ' ' << time_s;
    }
}

TEST_F(headless_sequence, small_meshes_are_not_held_while_a_geometry_cache_plays) {
  const Bytes bytes = gliding_cache();
  const LoadedScene loaded = scene_of_cache_file(bytes);
  Options options = far_away(Updates::held);
  options.frames = FrameRange{0, 4};
  EXPECT_EQ(sequence(options, loaded, kNone), alone(options, loaded, loaded.cache->duration_s(), kNone));
  EXPECT_TRUE(plan_says("every frame: a geometry cache plays")) << plan_;
}

}  // namespace
}  // namespace sinew::viewer
