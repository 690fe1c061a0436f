// SPDX-License-Identifier: MIT
// The report of a frame for the live plan: draw counts of passes, and what was skipped.
#include "tests/viewer/device_fixture.h"
#include "viewer/app/headless.h"

namespace sinew::viewer {
namespace {

class frame_report : public DeviceTest {};

constexpr std::uint32_t kWidth = 30, kHeight = 20;

/// Three opaque draws, of which a copy is out of view, two that blend, and two lamps that cast shadows.
BuiltScene counted_scene() {
  BuiltScene built = box_and_sphere_on_floor();
  built.scene.instances[1].copies = {Transform{}, Transform{{60, 0, 0}, {1, 0, 0, 0}, {1, 1, 1}}};
  Material pane = matte({0.3f, 0.8f, 0.4f});
  pane.alpha_mode = AlphaMode::blend;
  for (const float y : {1.5f, 1.7f}) built.add(square(0.3f), built.add_material(pane), translation({0, y, 0}));
  for (const float x : {-1.0f, 1.0f}) {
    Affine from_above = translation({x, 4.0f, 0.5f});
    from_above.row[1] = {0.0f, 0.0f, 1.0f, 4.0f};
    from_above.row[2] = {0.0f, -1.0f, 0.0f, 0.5f};
    built.add_light({.kind = Light::Kind::spot, .intensity = 6.0f}, from_above);
  }
  return built;
}

std::uint64_t count_of(const FrameReport& report, Pass pass) {
  return report.passes[static_cast<std::size_t>(pass)].count;
}

TEST_F(frame_report, counts_what_each_pass_draws) {
  const BuiltScene built = counted_scene();
  const View view = look_at({2.5, 2.2, 4.0}, {0.0, 0.4, 0.0}, 0.8, 0.05);
  const std::vector<LineVertex> lines(6);
  Headless pictures(*test_device(), built.scene, kWidth, kHeight, {}, nullptr, {FilterKind::bilinear});
  RenderOptions options;
  options.shadows = {true, {glm::vec3(-3.0f), glm::vec3(3.0f)}};
  for (const Transparency how : {Transparency::sorted, Transparency::weighted}) {
    options.transparency = how;
    pictures.render(built.frame(), view, options, lines);
    const FrameReport& report = pictures.report();
    EXPECT_EQ(count_of(report, Pass::shadow), how == Transparency::sorted ? 2u * 4u : 0u)
        << "two lamps see the copy that is out of view, too";
    EXPECT_EQ(count_of(report, Pass::normal_depth), 3u);
    EXPECT_EQ(count_of(report, Pass::opaque), 3u);
    EXPECT_EQ(count_of(report, Pass::transparent), how == Transparency::sorted ? 2u : 0u);
    EXPECT_EQ(count_of(report, Pass::weighted), how == Transparency::weighted ? 2u : 0u);
    EXPECT_EQ(count_of(report, Pass::overlay), 3u);
    EXPECT_GT(count_of(report, Pass::tonemap), kWidth * kHeight / 4);
    EXPECT_LE(count_of(report, Pass::tonemap), kWidth * kHeight);
    EXPECT_EQ(report.drawn, 5u);
    EXPECT_EQ(report.out_of_view, 1u);
    EXPECT_EQ(report.hidden, 0u);
    EXPECT_EQ(report.modes[1].reason, "four texels of the full image");
  }
}

TEST_F(frame_report, counts_every_copy_of_what_was_left_out_before_and_what_is_hidden_by_itself) {
  const BuiltScene built = counted_scene();
  const View view = look_at({2.5, 2.2, 4.0}, {0.0, 0.4, 0.0}, 0.8, 0.05);
  Headless pictures(*test_device(), built.scene, kWidth, kHeight);
  FrameResult frame = built.frame();
  std::vector<InstanceResult> instances(frame.instances.begin(), frame.instances.end());
  instances[1].visible = instances[2].visible = false;
  frame.instances = instances;
  RenderOptions options;
  options.ao.on = false;
  pictures.render(frame, view, options);
  EXPECT_EQ(pictures.report().out_of_view, 2u + 1u);
  EXPECT_EQ(pictures.report().drawn, 3u);
  std::vector<char> hidden(frame.model.size(), 0);
  hidden[built.scene.instances[1].joint] = 1;
  frame.hidden = {reinterpret_cast<const bool*>(hidden.data()), hidden.size()};
  pictures.render(frame, view, options);
  EXPECT_EQ(pictures.report().out_of_view, 1u);
  EXPECT_EQ(pictures.report().hidden, 1u);
}

}  // namespace
}  // namespace sinew::viewer
