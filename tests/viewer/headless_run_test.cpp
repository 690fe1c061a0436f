// SPDX-License-Identifier: MIT
// Pictures that the program writes without a window: byte for byte those of the view, the time and the look that the
// options say, each made here by itself.
#include "viewer/app/headless_run.h"

#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

#include "runtime/plan/run_plan.h"
#include "samples/showcase/scene_builder.h"
#include "samples/showcase/shapes.h"
#include "tests/viewer/device_fixture.h"
#include "viewer/app/file_camera.h"
#include "viewer/app/headless.h"
#include "viewer/app/orbit_camera.h"
#include "viewer/app/png_writer.h"
#include "viewer/app/settings.h"
#include "viewer/app/skeleton_lines.h"

namespace sinew::viewer {
namespace {

namespace fs = std::filesystem;

constexpr double kAspect = 1.5;
constexpr double kDuration_s = 1.6;

Material glowing(const char* name, const glm::vec3& color) {
  Material material;
  material.name = name;
  material.unlit = true;
  material.base_color = glm::vec4(color, 1.0f);
  return material;
}

/// A box that glides 2 m to the right beside one that stands, with a camera on the one that glides and one far before
/// both, which glides as well.
Exhibit gliding_box() {
  showcase::SceneBuilder builder;
  const std::uint32_t red = builder.add_material(glowing("red", {1, 0, 0})),
                      blue = builder.add_material(glowing("blue", {0, 0, 1}));
  const std::uint32_t joint = builder.add_joint("box", kNone, {}), eye = builder.add_joint("eye", kNone, {});
  Mesh mesh{"box", {showcase::box({0, 0, 0}, {0.5f, 0.3f, 0.2f})}, {}, {}};
  mesh.primitives[0].material = red;
  builder.add_instance(joint, builder.add_mesh(std::move(mesh)));
  builder.add_prop("still", showcase::box({0, 0, -2}, glm::vec3(0.6f)), blue);
  BoneAnimation bone;
  bone.joint = joint;
  bone.translation.times_s = {0.0f, static_cast<float>(kDuration_s)};
  bone.translation.values = {{0, 0, 0}, {2, 0.5f, 0}};
  BoneAnimation seen_from = bone;
  seen_from.joint = eye;
  seen_from.translation.values = {{0, 0, 70}, {1, 0, 70}};
  builder.add_animation({"glide", kDuration_s, {bone, seen_from}, {}});
  Exhibit exhibit;
  exhibit.scene = builder.finish();
  exhibit.scene.variants = {"red", "blue"};
  exhibit.scene.meshes[0].primitives[0].variant_materials = {{1, blue}};
  exhibit.scene.cameras = {{.name = "on box", .joint = joint, .fov_y_rad = 1.2f},
                           {.name = "far", .joint = eye, .fov_y_rad = 0.17f}};
  exhibit.name = "gliding box";
  return exhibit;
}

Options small_picture() {
  Options options;
  options.width = 48;
  options.height = 32;
  options.ambient_occlusion = options.shadows = false;
  options.ground = GroundLook::none;
  options.smooth_edges = false;
  return options;
}

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {(std::istreambuf_iterator<char>(in)), {}};
}

class headless_run : public DeviceTest {
 protected:
  void SetUp() override {
    DeviceTest::SetUp();
    fs::create_directories(folder_);
  }
  void TearDown() override {
    fs::remove_all(folder_);
    DeviceTest::TearDown();
  }

  /// What the program writes.
  std::string written(Options options, const Exhibit& exhibit, std::uint32_t clip = 0) {
    options.headless = (folder_ / "a.png").string();
    EXPECT_EQ(write_pictures(*test_device(), options, exhibit, clip), 0);
    return bytes_of(options.headless);
  }
  /// The picture of this view, evaluated and drawn here.
  std::string drawn(Options options, const Exhibit& exhibit, const View& view, double time_s, std::uint32_t clip = 0) {
    options.headless = "a.png";
    const Settings settings = settings_from(options, exhibit.scene);
    const Plan plan = compile_plan(exhibit.scene, needs_of(exhibit, {settings.skinning, Updates::every}));
    FrameBuffer frame(plan);
    const ClipLayer layer{clip, time_s};
    FrameInput input;
    if (clip != kNone) input.layers = {&layer, 1};
    EXPECT_EQ(run_plan(plan, input, frame), ErrorCode::ok);
    const ClipExtent extent = clip_extent(exhibit.scene, clip);
    RenderOptions look = render_options(settings, exhibit.environment, extent, eye_of(view));
    look.transparent_background = options.transparent;
    SkeletonLines skeleton(exhibit.scene);
    const auto lines = skeleton.make(frame.result().model, skeleton.axis_length_m(extent.largest));
    Headless renderer(*test_device(), exhibit.scene, options.width, options.height, {}, exhibit.access.get(),
                      options.filter);
    const AccessBlend access = exhibit.access ? access_blend(*exhibit.access, clip, time_s) : AccessBlend{};
    PngWriter writer;
    writer.write(folder_ / "b.png",
                 renderer.render(frame.result(), view, look, settings.skeleton ? lines : std::span<const LineVertex>(),
                                 settings.variant, access));
    EXPECT_TRUE(writer.finish().empty());
    return bytes_of(folder_ / "b.png");
  }

  fs::path folder_ = fs::temp_directory_path() / ("sinew-headless-run-" + std::to_string(getpid()));
};

View orbiting(const Exhibit& exhibit, std::span<const glm::vec3> points, double fov_y_rad,
              const glm::vec3& moved = glm::vec3(0.0f)) {
  OrbitCamera camera;
  camera.fov_y_rad = fov_y_rad;
  camera.frame(points, kAspect);
  camera.target += glm::dvec3(moved);
  return camera.view(clip_extent(exhibit.scene, 0).reached);
}

View placed(const Exhibit& exhibit, const PlacedCamera& camera, double fov_y_rad) {
  const glm::dvec3 eye(camera.eye);
  return look_at(eye, camera.target, fov_y_rad, near_plane_for(eye, clip_extent(exhibit.scene, 0).reached));
}

TEST_F(headless_run, frames_the_whole_clip_with_the_angle_of_the_exhibit_or_the_one_that_is_asked_for) {
  Exhibit exhibit = gliding_box();
  const ClipExtent extent = clip_extent(exhibit.scene, 0);
  Options options = small_picture();
  for (const double fov : {exhibit.fov_y_rad, 0.5}) {
    exhibit.fov_y_rad = fov;
    EXPECT_EQ(written(options, exhibit), drawn(options, exhibit, orbiting(exhibit, extent.outline.points(), fov), 0.0));
  }
  options.fov_y_deg = 90.0;
  const View wide = orbiting(exhibit, extent.outline.points(), std::atan(1.0) * 2.0);
  for (const double time_s : {0.0, 1.2}) {
    options.time_s = time_s;
    EXPECT_EQ(written(options, exhibit), drawn(options, exhibit, wide, time_s));
  }
}

TEST_F(headless_run, looks_from_where_the_user_else_the_exhibit_says) {
  Exhibit exhibit = gliding_box();
  Options options = small_picture();
  options.time_s = 0.8;
  exhibit.camera = PlacedCamera{{1, 2, 5}, {0.5f, 0, 0}};
  EXPECT_EQ(written(options, exhibit),
            drawn(options, exhibit, placed(exhibit, *exhibit.camera, exhibit.fov_y_rad), 0.8));
  options.camera = PlacedCamera{{1, 6, 0.1f}, {1, 0, 0}};
  options.fov_y_deg = 30.0;
  EXPECT_EQ(written(options, exhibit),
            drawn(options, exhibit, placed(exhibit, *options.camera, 0.523598775598299), 0.8));
}

TEST_F(headless_run, frames_one_pose_or_goes_along_whatever_the_exhibit_says) {
  Exhibit exhibit = gliding_box();
  exhibit.camera = PlacedCamera{{1, 2, 5}, {0.5f, 0, 0}};
  Options options = small_picture();
  options.time_s = 1.2;
  options.framing = Framing::pose;
  const Framed pose = framed(Framing::pose, exhibit.scene, 0, 1.2),
               along = framed(Framing::follow, exhibit.scene, 0, 0);
  EXPECT_EQ(written(options, exhibit),
            drawn(options, exhibit, orbiting(exhibit, pose.outline.points(), exhibit.fov_y_rad), 1.2));
  options.framing = Framing::follow;
  const glm::vec3 gone(along.place_at(1.2));
  EXPECT_GT(glm::length(gone), 0.5f);
  EXPECT_EQ(written(options, exhibit),
            drawn(options, exhibit, orbiting(exhibit, along.outline.points(), exhibit.fov_y_rad, gone), 1.2));
}

TEST_F(headless_run, looks_through_a_camera_of_the_file_that_moves_with_the_clip) {
  const Exhibit exhibit = gliding_box();
  Options options = small_picture();
  options.file_camera = "on box";
  for (const double time_s : {0.0, 1.2}) {
    options.time_s = time_s;
    Affine box;
    box.row[0].w = static_cast<float>(2.0 * time_s / kDuration_s);
    box.row[1].w = static_cast<float>(0.5 * time_s / kDuration_s);
    const View view = view_of_camera(exhibit.scene.cameras[0], box, kAspect, clip_extent(exhibit.scene, 0).reached);
    EXPECT_EQ(written(options, exhibit), drawn(options, exhibit, view, time_s)) << time_s;
  }
}

TEST_F(headless_run, shows_what_is_asked_for_over_and_in_the_picture) {
  Exhibit exhibit = gliding_box();
  exhibit.environment = plain_environment();
  const View view = orbiting(exhibit, clip_extent(exhibit.scene, 0).outline.points(), exhibit.fov_y_rad);
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
    pictures.push_back(written(options, exhibit));
    EXPECT_EQ(pictures.back(), drawn(options, exhibit, view, 0.4)) << pictures.size() - 1;
    if (pictures.size() > 1) {
      EXPECT_NE(pictures.back(), pictures.front()) << pictures.size() - 1;
    }
  }
}

TEST_F(headless_run, ambient_access_at_vertices_is_that_of_the_time) {
  Exhibit exhibit = gliding_box();
  VertexAccess access;
  access.times_s = {0.0, kDuration_s};
  access.clip = 0;
  for (const Mesh& mesh : exhibit.scene.meshes) {
    const std::size_t vertices = mesh.primitives[0].vertex_count();
    std::vector<float> values(vertices, 0.9f);
    values.resize(2 * vertices, 0.1f);
    access.values.push_back({values});
  }
  exhibit.access = std::make_shared<const VertexAccess>(access);
  Options options = small_picture();
  options.ambient_occlusion = true;
  options.occlusion_method = OcclusionMethod::rays;
  options.show = Show::ao;
  const View view = orbiting(exhibit, clip_extent(exhibit.scene, 0).outline.points(), exhibit.fov_y_rad);
  std::string before;
  for (const double time_s : {0.2, 1.4}) {
    options.time_s = time_s;
    const std::string picture = written(options, exhibit);
    EXPECT_EQ(picture, drawn(options, exhibit, view, time_s));
    EXPECT_NE(picture, before);
    before = picture;
  }
}

TEST_F(headless_run, the_rest_pose_is_shown_without_a_clip) {
  const Exhibit exhibit = gliding_box();
  Options options = small_picture();
  options.time_s = 1.2;
  OrbitCamera camera;
  camera.fov_y_rad = exhibit.fov_y_rad;
  const ClipExtent extent = clip_extent(exhibit.scene, kNone);
  camera.frame(extent.outline.points(), kAspect);
  EXPECT_EQ(written(options, exhibit, kNone), drawn(options, exhibit, camera.view(extent.reached), 0.0, kNone));
}

TEST_F(headless_run, sequences_are_numbered_and_each_picture_is_that_of_its_time) {
  const Exhibit exhibit = gliding_box();
  Options options = small_picture();
  options.frames = FrameRange{3, 7};
  options.fps = 4.0;
  options.headless = (folder_ / "new" / "frames").string();
  ASSERT_EQ(write_pictures(*test_device(), options, exhibit, 0), 0);
  Options one = small_picture();
  for (std::uint32_t n = 3; n <= 7; ++n) {
    one.time_s = picture_time_s(n, 4.0, kDuration_s);
    EXPECT_EQ(bytes_of(fs::path(options.headless) / ("0000" + std::to_string(n) + ".png")), written(one, exhibit)) << n;
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(options.headless), {}), 5);
  options.framing = Framing::pose;  // that of the first picture
  options.frames = FrameRange{4, 4};
  ASSERT_EQ(write_pictures(*test_device(), options, exhibit, 0), 0);
  one.framing = Framing::pose;
  one.time_s = 1.0;
  EXPECT_EQ(bytes_of(fs::path(options.headless) / "00004.png"), written(one, exhibit));
}

TEST_F(headless_run, small_meshes_are_held_between_updates_only_where_pictures_are_near_in_time) {
  const Exhibit exhibit = gliding_box();
  Options options = small_picture();
  options.updates = Updates::held;
  options.camera = PlacedCamera{{0, 0, 70}, {0, 0, 0}};
  options.fov_y_deg = 10.0;
  options.width = 192;
  options.height = 128;
  options.smooth_edges = true;  // so that it is seen to move
  for (const double fps : {25.0, 5.0}) {
    options.fps = fps;
    options.frames = FrameRange{0, 5};
    options.headless = (folder_ / std::to_string(static_cast<int>(fps))).string();
    ASSERT_EQ(write_pictures(*test_device(), options, exhibit, 0), 0);
    int held = 0;
    for (int n = 0; n < 5; ++n) {
      const auto file = [&](int i) { return fs::path(options.headless) / ("0000" + std::to_string(i) + ".png"); };
      held += bytes_of(file(n)) == bytes_of(file(n + 1));
    }
    EXPECT_EQ(held > 0, fps > 20.0) << fps;
    EXPECT_LT(held, 4) << fps;
  }
}

TEST_F(headless_run, small_meshes_are_not_held_while_the_camera_moves) {
  const Exhibit exhibit = gliding_box();
  Options options = small_picture();
  options.file_camera = "far";
  options.width = 192;
  options.height = 128;
  options.smooth_edges = true;
  Options one = options;
  options.updates = Updates::held;
  options.fps = 25.0;
  options.frames = FrameRange{0, 4};
  options.headless = (folder_ / "held").string();
  options.plan = true;
  testing::internal::CaptureStdout();
  ASSERT_EQ(write_pictures(*test_device(), options, exhibit, 0), 0);
  const std::string plan = testing::internal::GetCapturedStdout();
  EXPECT_NE(plan.find("every frame: the camera moves with the clip"), std::string::npos) << plan;
  for (std::uint32_t n = 0; n <= 4; ++n) {
    one.time_s = picture_time_s(n, options.fps, kDuration_s);
    EXPECT_EQ(bytes_of(fs::path(options.headless) / ("0000" + std::to_string(n) + ".png")), written(one, exhibit)) << n;
  }
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
  const Exhibit exhibit = gliding_box();
  Options options = small_picture();
  testing::internal::CaptureStdout();
  written(options, exhibit);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  options.plan = true;
  testing::internal::CaptureStdout();
  written(options, exhibit);
  const std::string plan = testing::internal::GetCapturedStdout();
  for (const char* row : {"evaluation, on the CPU\n  update rate", "every frame: one picture", "\n  sample ",
                          "drawing, on the CPU\n  upload ", "modes of the picture\n  samples ",
                          "passes, on the GPU\n  shadow ", "edges are not smoothed"})
    EXPECT_NE(plan.find(row), std::string::npos) << row << plan;
}

TEST(png_writer, is_finished_when_the_last_picture_is_written_and_not_when_it_is_begun) {
  const fs::path pipe = fs::temp_directory_path() / ("sinew-png-writer-" + std::to_string(getpid()));
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::atomic<bool> begun = false;
  std::thread reader([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(60));
    begun = true;  // until somebody reads, the writer waits
    EXPECT_FALSE(bytes_of(pipe).empty());
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
  const Exhibit exhibit = gliding_box();
  Options options = small_picture();
  std::ofstream(folder_ / "file") << "x";
  const auto complaint = [&](const std::string& to) {
    options.headless = to;
    testing::internal::CaptureStderr();
    EXPECT_EQ(write_pictures(*test_device(), options, exhibit, 0), 3) << to;
    return testing::internal::GetCapturedStderr();
  };
  EXPECT_NE(complaint((folder_ / "none" / "a.png").string()).find("none/a.png: cannot be written"), std::string::npos);
  options.frames = FrameRange{0, 1};
  EXPECT_NE(complaint((folder_ / "file" / "frames").string()).find("file/frames: "), std::string::npos);
}

}  // namespace
}  // namespace sinew::viewer
