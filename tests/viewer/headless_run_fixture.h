// SPDX-License-Identifier: MIT
// What the program writes without a window, and the same picture made here by itself.
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
#include "viewer/app/png_writer.h"
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

/// A box that glides 2 m to the right beside one that stands, with a camera on the one that glides and one far before
/// both, which glides as well.
inline Exhibit gliding_box() {
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

  /// What the program writes.
  std::string written(Options options, const Exhibit& exhibit, std::uint32_t clip = 0) {
    options.headless = (folder_ / "a.png").string();
    EXPECT_EQ(write_pictures(*test_device(), options, exhibit, clip), 0);
    return test::text_of_file(options.headless);
  }
  /// The picture of this view, evaluated and drawn here.
  std::string drawn(Options options, const Exhibit& exhibit, const View& view, double time_s, std::uint32_t clip = 0) {
    options.headless = "a.png";
    const Settings settings = settings_from(options, exhibit.scene);
    const Plan plan = compile_plan(lend(exhibit.scene), needs_of(exhibit, {settings.skinning, Updates::every}));
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
    return test::text_of_file(folder_ / "b.png");
  }

  fs::path folder_ = fs::temp_directory_path() / ("sinew-headless-run-" + std::to_string(getpid()));
};

inline View placed(const Exhibit& exhibit, const PlacedCamera& camera, double fov_y_rad) {
  const glm::dvec3 eye(camera.eye);
  return look_at(eye, camera.target, fov_y_rad, near_plane_for(eye, clip_extent(exhibit.scene, 0).reached));
}

}  // namespace sinew::viewer
