// SPDX-License-Identifier: MIT
// Pictures written by the program without a window. They must be byte-identical to pictures that the test draws with
// the view, time and look of the options.
#include <sys/stat.h>

#include <gmock/gmock.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

#include "tests/viewer/flyer.h"
#include "tests/viewer/headless_run_fixture.h"
#include "viewer/app/camera/file_camera.h"
#include "viewer/app/camera/orbit_camera.h"

namespace sinew::viewer {
namespace {

class headless_run : public HeadlessRunTest {};

View orbiting(const LoadedScene& loaded, std::span<const glm::vec3> points, double fov_y_rad,
              const glm::vec3& moved = glm::vec3(0.0f)) {
  OrbitCamera camera;
  camera.fov_y_rad = fov_y_rad;
  camera.frame(points, kAspect);
  camera.target += glm::dvec3(moved);
  return camera.view(clip_extent(loaded.scene, 0).reached);
}

TEST_F(headless_run, frames_the_whole_clip_with_the_angle_of_the_scene_or_the_one_that_is_asked_for) {
  LoadedScene loaded = gliding_box();
  const ClipExtent extent = clip_extent(loaded.scene, 0);
  Options options = small_picture();
  for (const double fov : {loaded.fov_y_rad, 0.5}) {
    loaded.fov_y_rad = fov;
    EXPECT_EQ(written(options, loaded), drawn(options, loaded, orbiting(loaded, extent.outline.points(), fov), 0.0));
  }
  options.fov_y_deg = 90.0;
  const View wide = orbiting(loaded, extent.outline.points(), std::atan(1.0) * 2.0);
  for (const double time_s : {0.0, 1.2}) {
    options.time_s = time_s;
    EXPECT_EQ(written(options, loaded), drawn(options, loaded, wide, time_s));
  }
}

TEST_F(headless_run, looks_from_where_the_user_else_the_scene_says) {
  LoadedScene loaded = gliding_box();
  Options options = small_picture();
  options.time_s = 0.8;
  loaded.camera = PlacedCamera{{1, 2, 5}, {0.5f, 0, 0}};
  EXPECT_EQ(written(options, loaded), drawn(options, loaded, placed(loaded, *loaded.camera, loaded.fov_y_rad), 0.8));
  options.camera = PlacedCamera{{1, 6, 0.1f}, {1, 0, 0}};
  options.fov_y_deg = 30.0;
  EXPECT_EQ(written(options, loaded), drawn(options, loaded, placed(loaded, *options.camera, 0.523598775598299), 0.8));
}

TEST_F(headless_run, a_placed_camera_sees_what_the_clip_brings_near) {
  showcase::SceneBuilder builder;
  const std::uint32_t red = builder.add_material(glowing("red", {1, 0, 0})),
                      joint = builder.add_joint("box", kNone, {});
  Mesh mesh{"box", {showcase::box({0, 0, 0}, glm::vec3(0.3f))}, {}, {}};
  mesh.primitives[0].material = red;
  builder.add_instance(joint, builder.add_mesh(std::move(mesh)));
  builder.add_prop("still", showcase::box({6, 0, 0}, glm::vec3(0.3f)), red);
  BoneAnimation bone;
  bone.joint = joint;
  bone.translation.times_s = {0.0f, static_cast<float>(kDuration_s)};
  bone.translation.values = {{0, 0, 0}, {5, 0, 4}};
  builder.add_animation({"come", kDuration_s, {bone}, {}});
  LoadedScene loaded;
  loaded.scene = builder.finish();
  Options options = small_picture();
  options.camera = PlacedCamera{{5, 0, 5.5f}, {5, 0, 0}};
  options.time_s = kDuration_s;
  const View view = placed(loaded, *options.camera, loaded.fov_y_rad);
  const std::string picture = drawn(options, loaded, view, kDuration_s);
  EXPECT_EQ(written(options, loaded), picture);
  const glm::dvec3 eye(options.camera->eye);
  const View late =
      look_at(eye, options.camera->target, loaded.fov_y_rad, near_plane_for(eye, clip_extent(loaded.scene, 0).largest));
  EXPECT_NE(drawn(options, loaded, late, kDuration_s), picture) << "that of the largest pose cuts the box off";
}

TEST_F(headless_run, frames_one_pose_or_goes_along_whatever_the_scene_says) {
  LoadedScene loaded = gliding_box();
  loaded.camera = PlacedCamera{{1, 2, 5}, {0.5f, 0, 0}};
  Options options = small_picture();
  options.time_s = 1.2;
  options.framing = Framing::pose;
  const Framed pose = framed(Framing::pose, loaded.scene, 0, 1.2), along = framed(Framing::follow, loaded.scene, 0, 0);
  EXPECT_EQ(written(options, loaded),
            drawn(options, loaded, orbiting(loaded, pose.outline.points(), loaded.fov_y_rad), 1.2));
  options.framing = Framing::follow;
  const glm::vec3 gone(along.offset_at(1.2));
  EXPECT_GT(glm::length(gone), 0.5f);
  EXPECT_EQ(written(options, loaded),
            drawn(options, loaded, orbiting(loaded, along.outline.points(), loaded.fov_y_rad, gone), 1.2));
}

TEST_F(headless_run, looks_through_a_camera_of_the_file_that_moves_with_the_clip) {
  const LoadedScene loaded = gliding_box();
  Options options = small_picture();
  options.file_camera = "on box";
  for (const double time_s : {0.0, 1.2}) {
    options.time_s = time_s;
    Affine box;
    box.row[0].w = static_cast<float>(2.0 * time_s / kDuration_s);
    box.row[1].w = static_cast<float>(0.5 * time_s / kDuration_s);
    const View view = view_of_camera(loaded.scene.cameras[0], box, kAspect, clip_extent(loaded.scene, 0).reached);
    EXPECT_EQ(written(options, loaded), drawn(options, loaded, view, time_s)) << time_s;
  }
}

TEST_F(headless_run, shows_what_is_asked_for_over_and_in_the_picture) {
  LoadedScene loaded = gliding_box();
  loaded.environment = plain_environment();
  const View view = orbiting(loaded, clip_extent(loaded.scene, 0).outline.points(), loaded.fov_y_rad);
  std::vector<Options> all(7, small_picture());
  all[1].skeleton = true;
  all[1].width = 240;  // axes of a few pixels
  all[1].height = 160;
  all[2].variant = "blue";
  all[3].transparent = true;
  all[4].backdrop = Backdrop::sharp;
  all[5].show = Show::depth;
  all[6].smooth_edges = true;
  std::vector<std::string> pictures;
  for (Options& options : all) {
    options.time_s = 0.4;
    pictures.push_back(written(options, loaded));
    EXPECT_EQ(pictures.back(), drawn(options, loaded, view, 0.4)) << pictures.size() - 1;
    if (pictures.size() > 1) {
      EXPECT_NE(pictures.back(), pictures.front()) << pictures.size() - 1;
    }
  }
}

TEST_F(headless_run, axes_of_joints_are_as_long_as_the_largest_pose_asks_for_however_far_the_clip_goes) {
  LoadedScene loaded;
  loaded.scene = flyer(true);
  Options options = small_picture();
  options.skeleton = true;
  options.width = 240;
  options.height = 160;
  options.camera = PlacedCamera{{0.5f, 0.5f, 3.0f}, {0.5f, 0.5f, 0.0f}};
  EXPECT_EQ(written(options, loaded), drawn(options, loaded, placed(loaded, *options.camera, loaded.fov_y_rad), 0));
}

TEST_F(headless_run, ambient_visibility_at_vertices_is_that_of_the_time) {
  LoadedScene loaded = gliding_box();
  VertexVisibility visibility;
  visibility.times_s = {0.0, kDuration_s};
  visibility.clip = 0;
  for (const Mesh& mesh : loaded.scene.meshes) {
    const std::size_t vertices = mesh.primitives[0].vertex_count();
    std::vector<float> values(vertices, 0.9f);
    values.resize(2 * vertices, 0.1f);
    visibility.values.push_back({values});
  }
  loaded.visibility = std::make_shared<const VertexVisibility>(visibility);
  Options options = small_picture();
  options.ambient_occlusion = true;
  options.occlusion_method = OcclusionMethod::rays;
  options.show = Show::ao;
  const View view = orbiting(loaded, clip_extent(loaded.scene, 0).outline.points(), loaded.fov_y_rad);
  std::string before;
  for (const double time_s : {0.2, 1.4}) {
    options.time_s = time_s;
    const std::string picture = written(options, loaded);
    EXPECT_EQ(picture, drawn(options, loaded, view, time_s));
    EXPECT_NE(picture, before);
    before = picture;
  }
}

TEST_F(headless_run, what_the_clip_or_a_shadow_brings_into_view_is_drawn) {
  const LoadedScene loaded = gliding_box();
  Options options = small_picture();
  options.time_s = kDuration_s;
  options.camera = PlacedCamera{{2, 0.5f, 1.6f}, {2, 0.5f, 0}};  // sees the box only at the clip's end
  const auto seen = [&] { return placed(loaded, *options.camera, loaded.fov_y_rad); };
  const std::string end = written(options, loaded);
  EXPECT_EQ(end, drawn(options, loaded, seen(), kDuration_s));
  EXPECT_NE(end, written(options, loaded, kNone));
  options.camera = PlacedCamera{{1.4f, -0.35f, -0.5f}, {1.4f, -0.6f, -0.75f}};  // the ground alone
  options.fov_y_deg = 20.0;
  options.ground = GroundLook::shadows;
  const std::string bright = written(options, loaded);
  options.shadows = true;
  const std::string dark = written(options, loaded);
  EXPECT_NE(dark, bright);
  EXPECT_EQ(dark, drawn(options, loaded, placed(loaded, *options.camera, 0.349065850398866), kDuration_s));
}

TEST_F(headless_run, the_rest_pose_is_shown_without_a_clip) {
  const LoadedScene loaded = gliding_box();
  Options options = small_picture();
  options.time_s = 1.2;
  OrbitCamera camera;
  camera.fov_y_rad = loaded.fov_y_rad;
  const ClipExtent extent = clip_extent(loaded.scene, kNone);
  camera.frame(extent.outline.points(), kAspect);
  EXPECT_EQ(written(options, loaded, kNone), drawn(options, loaded, camera.view(extent.reached), 0.0, kNone));
}

TEST(picture_time, goes_on_by_the_rate_and_starts_again_after_the_end) {
  EXPECT_EQ(picture_time_s(0, 30.0, 2.0), 0.0);
  EXPECT_EQ(picture_time_s(7, 4.0, 2.0), 1.75);
  EXPECT_EQ(picture_time_s(8, 4.0, 2.0), 2.0) << "exactly at the end it shows the end";
  EXPECT_EQ(picture_time_s(9, 4.0, 2.0), 0.25);
  EXPECT_EQ(picture_time_s(27, 4.0, 2.0), 0.75);
  EXPECT_EQ(picture_time_s(27, 4.0, 0.0), 6.75) << "nothing to repeat";
}

TEST_F(headless_run, prints_the_plan_of_the_last_picture_with_times_that_are_not_those_of_the_first) {
  const LoadedScene loaded = gliding_box();
  Options options = small_picture();
  testing::internal::CaptureStdout();
  written(options, loaded);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  options.plan = true;
  testing::internal::CaptureStdout();
  written(options, loaded);
  const std::string plan = testing::internal::GetCapturedStdout();
  for (const char* row : {"evaluation, on the CPU\n  update rate", "every frame: one picture", "\n  sample ",
                          "drawing, on the CPU\n  upload ", "modes of the picture\n  samples ",
                          "passes, on the GPU\n  shadow ", "edges are not smoothed"})
    EXPECT_NE(plan.find(row), std::string::npos) << row << plan;
  const std::size_t sample = plan.find("\n  sample ") + 1;
  EXPECT_NE(plan.substr(sample, plan.find('\n', sample) - sample).find(" us  "), std::string::npos) << plan;
}

TEST(png_writer, is_finished_when_the_last_picture_is_written_and_not_when_it_is_begun) {
  const fs::path pipe = fs::temp_directory_path() / ("sinew-png-writer-" + std::to_string(getpid()));
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::atomic<bool> begun = false;
  std::thread reader([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(60));
    begun = true;  // until somebody reads, the writer waits
    EXPECT_FALSE(test::text_of_file(pipe).empty());
  });
  PngWriter writer;
  writer.write(pipe, Picture{1, 1, {1, 2, 3, 4}});
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_TRUE(writer.finish().empty());
  EXPECT_TRUE(begun);
  reader.join();
  fs::remove(pipe);
}

TEST_F(headless_run, says_what_cannot_be_written) {
  const LoadedScene loaded = gliding_box();
  Options options = small_picture();
  std::ofstream(folder_ / "file") << "x";
  const auto complaint = [&](const std::string& to) {
    options.headless = to;
    testing::internal::CaptureStderr();
    EXPECT_EQ(write_pictures(*test_device(), options, loaded, 0), 3) << to;
    return testing::internal::GetCapturedStderr();
  };
  EXPECT_NE(complaint((folder_ / "none" / "a.png").string()).find("none/a.png: cannot be written"), std::string::npos);
  options.frames = FrameRange{0, 1};
  EXPECT_NE(complaint((folder_ / "file" / "frames").string()).find("file/frames: "), std::string::npos);
}

TEST_F(headless_run, a_turntable_goes_around_from_the_view_of_the_single_picture) {
  const LoadedScene loaded = gliding_box();
  Options options = small_picture();
  const std::string single = written(options, loaded);
  options.turntable = 4;
  options.headless = (folder_ / "turn").string();
  ASSERT_EQ(write_pictures(*test_device(), options, loaded, 0), 0);
  EXPECT_EQ(test::text_of_file(folder_ / "turn" / "00000.png"), single);
  OrbitCamera camera;
  camera.frame(clip_extent(loaded.scene, 0).outline.points(), kAspect);
  camera.yaw_rad += std::acos(-1.0) / 2.0;
  options.turntable = 0;
  EXPECT_EQ(test::text_of_file(folder_ / "turn" / "00001.png"),
            drawn(options, loaded, camera.view(clip_extent(loaded.scene, 0).reached), 0.0));
}

TEST_F(headless_run, a_comparison_of_equal_views_is_blue_and_of_a_budget_stays_within_it) {
  std::vector<LoadedScene> loaded(1);
  loaded[0] = gliding_box();
  Options options = small_picture();
  options.headless = (folder_ / "compared.png").string();
  options.time_s = 0.7;
  const auto views = parse_views("linear,dual-quaternion,compiled=2", 1);
  ASSERT_TRUE(views);
  const auto comparison = Comparison::make(*test_device(), options, loaded, *views, 0);
  ASSERT_TRUE(comparison) << comparison.error();
  const Picture picture = (*comparison)->at(0.7, 0.0);
  EXPECT_EQ(picture.width, 3 * options.width + 4);
  EXPECT_EQ(picture.height, 2 * options.height + 2);
  const auto& rows = (*comparison)->rows();
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[1].worst_m, 0.0) << "nothing is skinned";
  EXPECT_LE(rows[2].worst_m, 2e-3);
  EXPECT_GT(rows[0].evaluation_us, 0.0);
  EXPECT_EQ(picture.rgba, (*comparison)->at(0.7, 0.0).rgba) << "the same bytes again";
  EXPECT_EQ(write_comparison(*test_device(), options, loaded, *views, 0), 0);
  loaded.push_back(gliding_box());
  loaded[1].scene.meshes[0].primitives.pop_back();
  const auto other = Comparison::make(*test_device(), options, loaded, *parse_views("files", 2), 0);
  ASSERT_FALSE(other);
  EXPECT_THAT(other.error(), testing::HasSubstr("has other meshes than gliding box"));
}

TEST_F(headless_run, a_sheet_has_a_row_of_five_poses_for_each_clip) {
  const LoadedScene loaded = gliding_box();
  Options options = small_picture();
  options.headless = options.sheet = (folder_ / "sheet.png").string();
  ASSERT_EQ(write_sheet(*test_device(), options, loaded), 0);
  const std::string png = test::text_of_file(options.sheet);
  const auto number = [&](std::size_t at) {
    return (static_cast<unsigned char>(png[at + 2]) << 8) + static_cast<unsigned char>(png[at + 3]);
  };
  ASSERT_GT(png.size(), 24u);
  EXPECT_EQ(number(16), 5 * 48 + 4 * 2) << "width, in the head of a PNG";
  EXPECT_EQ(number(20), 32);
}

TEST_F(headless_run, layers_are_drawn_as_the_runtime_evaluates_them) {
  const LoadedScene loaded = gliding_box();
  Options options = small_picture();
  options.camera = PlacedCamera{{1, 2, 5}, {0.5f, 0, 0}};
  const std::string still = written(options, loaded, kNone);
  options.layers = {{.clip = "glide", .weight = 0.0f}};
  EXPECT_EQ(written(options, loaded, kNone), still) << "a layer without weight";
  options.layers[0].weight = 1.0f;
  options.time_s = 0.8;
  const std::string covered = written(options, loaded, kNone);
  EXPECT_NE(covered, still);
  options.layers.clear();
  EXPECT_EQ(covered, written(options, loaded, 0)) << "a layer of weight 1 is the clip itself";
}

}  // namespace
}  // namespace sinew::viewer
