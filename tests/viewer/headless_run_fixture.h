// SPDX-License-Identifier: MIT
// Fixture that compares pictures written by the program with the same pictures drawn by the test.
#pragma once
#include <unistd.h>

#include <filesystem>
#include <string>

#include "runtime/plan/run_plan.h"
#include "samples/showcase/scene_builder.h"
#include "samples/showcase/shapes.h"
#include "tests/support/file_text.h"
#include "tests/viewer/device_fixture.h"
#include "viewer/app/headless.h"
#include "viewer/app/headless_run.h"
#include "viewer/app/pictures/png_writer.h"
#include "viewer/app/settings.h"
#include "viewer/app/skeleton_lines.h"

namespace sinew::viewer {

namespace fs = std::filesystem;

constexpr double kAspect = 1.5;
constexpr double kDuration_s = 1.6;

inline Material glowing(const char* name, const glm::vec3& color) {
  Material material;
  material.name = name;
  material.unlit = true;
  material.base_color = glm::vec4(color, 1.0f);
  return material;
}

/// A moving box (2 m to the right) next to a static one. One camera is on the moving box; another moving camera is far
/// in front of both.
inline LoadedScene gliding_box() {
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
  LoadedScene loaded;
  loaded.scene = builder.finish();
  loaded.scene.variants = {"red", "blue"};
  loaded.scene.meshes[0].primitives[0].variant_materials = {{1, blue}};
  loaded.scene.cameras = {{.name = "on box", .joint = joint, .fov_y_rad = 1.2f},
                          {.name = "far", .joint = eye, .fov_y_rad = 0.17f}};
  loaded.name = "gliding box";
  return loaded;
}

inline Options small_picture() {
  Options options;
  options.width = 48;
  options.height = 32;
  options.ambient_occlusion = options.shadows = false;
  options.ground = GroundLook::none;
  options.smooth_edges = false;
  return options;
}

class HeadlessRunTest : public DeviceTest {
 protected:
  void SetUp() override {
    DeviceTest::SetUp();
    fs::create_directories(folder_);
  }
  void TearDown() override {
    fs::remove_all(folder_);
    DeviceTest::TearDown();
  }

  /// The picture that the program writes.
  std::string written(Options options, const LoadedScene& loaded, std::uint32_t clip = 0) {
    options.headless = (folder_ / "a.png").string();
    EXPECT_EQ(write_pictures(*test_device(), options, loaded, clip), 0);
    return test::text_of_file(options.headless);
  }
  /// The picture of this view, evaluated and drawn by the test.
  std::string drawn(Options options, const LoadedScene& loaded, const View& view, double time_s,
                    std::uint32_t clip = 0) {
    options.headless = "a.png";
    const Settings settings = settings_from(options, loaded.scene);
    const Plan plan = compile_plan(lend(loaded.scene), needs_of(loaded, {settings.skinning, Updates::every}));
    FrameBuffer frame(plan);
    const ClipLayer layer{clip, time_s};
    FrameInput input;
    if (clip != kNone) input.layers = {&layer, 1};
    EXPECT_EQ(run_plan(plan, input, frame), ErrorCode::ok);
    const ClipExtent extent = clip_extent(loaded.scene, clip);
    RenderOptions look = render_options(settings, loaded.environment, extent, eye_of(view));
    look.transparent_background = options.transparent;
    SkeletonLines skeleton(loaded.scene);
    const auto lines = skeleton.make(frame.result().model, skeleton.axis_length_m(extent.largest));
    Headless renderer(*test_device(), loaded.scene, options.width, options.height, {}, loaded.visibility.get(),
                      options.filter);
    const VisibilityBlend visibility =
        loaded.visibility ? visibility_blend(*loaded.visibility, clip, time_s) : VisibilityBlend{};
    PngWriter writer;
    writer.write(folder_ / "b.png",
                 renderer.render(frame.result(), view, look, settings.skeleton ? lines : std::span<const LineVertex>(),
                                 settings.variant, visibility));
    EXPECT_TRUE(writer.finish().empty());
    return test::text_of_file(folder_ / "b.png");
  }

  fs::path folder_ = fs::temp_directory_path() / ("sinew-headless-run-" + std::to_string(getpid()));
};

inline View placed(const LoadedScene& loaded, const PlacedCamera& camera, double fov_y_rad) {
  const glm::dvec3 eye(camera.eye);
  return look_at(eye, camera.target, fov_y_rad, near_plane_for(eye, clip_extent(loaded.scene, 0).reached));
}

}  // namespace sinew::viewer
