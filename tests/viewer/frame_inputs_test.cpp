// SPDX-License-Identifier: MIT
// Inputs of a renderer that change from frame to frame: scenes, slots, picture size.
#include <cstring>

#include "samples/showcase/shapes.h"
#include "tests/viewer/device_fixture.h"
#include "viewer/device/buffer.h"
#include "viewer/device/image.h"

namespace sinew::viewer {
namespace {

constexpr VkFormat kFormat = VK_FORMAT_R8G8B8A8_UNORM;

using Pixels = std::vector<std::uint8_t>;

Pixels draw(FrameRenderer& renderer, const FrameInputs& inputs, VkExtent2D extent = {32, 24}) {
  const GpuImage image(*test_device(),
                       {kFormat, extent, 1, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT});
  const Buffer read(*test_device(), VkDeviceSize{4} * extent.width * extent.height, VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                    MemoryUse::read_back);
  test_device()->run_now([&](VkCommandBuffer commands) {
    renderer.record(commands, {image.handle(), image.view(), extent, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL}, inputs);
    read_back(commands, image.handle(), extent, read.handle());
  });
  Pixels pixels(read.size());
  std::memcpy(pixels.data(), read.mapped(), pixels.size());
  return pixels;
}

/// A scene on the device, with its frame in each slot.
struct Uploaded {
  explicit Uploaded(const BuiltScene& built, std::uint32_t slots = 1)
      : scene(*test_device(), built.scene, slots), frame(*test_device(), built.scene, slots) {
    for (std::uint32_t slot = 0; slot < slots; ++slot) show(slot, built.frame());
  }
  void show(std::uint32_t slot, const FrameResult& result) {
    frame.update(slot, result, ++updates);
    scene.update(slot, frame.look(slot));
  }
  DrawnScene drawn() const { return {&scene, &frame}; }

  SceneUpload scene;
  FrameUpload frame;
  std::uint64_t updates = 0;
};

void add_lamp(BuiltScene& built, float x, const glm::vec3& color) {
  Affine from_above = translation({x, 4.0f, 0.5f});  // shines along -y
  from_above.row[1] = {0.0f, 0.0f, 1.0f, 4.0f};
  from_above.row[2] = {0.0f, -1.0f, 0.0f, 0.5f};
  built.add_light({.kind = Light::Kind::spot, .color = color, .intensity = 8.0f}, from_above);
}

FrameInputs seen_from_aside() {
  FrameInputs inputs;
  inputs.view = look_at({2.5, 2.2, 4.0}, {0.0, 0.4, 0.0}, 0.8, 0.05);
  inputs.options.shadows = {true, {glm::vec3(-3.0f), glm::vec3(3.0f)}};
  return inputs;
}

class frame_inputs : public DeviceTest {};

TEST_F(frame_inputs, scenes_of_one_frame_are_a_picture_of_all_in_the_light_of_all) {
  BuiltScene all = box_and_sphere_on_floor(), first = box_and_sphere_on_floor(), second;
  Material pane = matte({0.3f, 0.8f, 0.4f}), sign = matte({1.0f, 0.5f, 0.0f});
  pane.alpha_mode = AlphaMode::blend;
  pane.base_color.a = 0.5f;
  sign.unlit = true;
  for (BuiltScene* built : {&all, &second}) {
    built->add(square(0.7f), built->add_material(pane), translation({0.2f, 1.3f, 0.3f}));
    built->add(showcase::sphere({-1.1f, 0.4f, 0.9f}, 0.25f, 12, 8), built->add_material(sign));
  }
  for (BuiltScene* built : {&all, &first}) add_lamp(*built, -1.0f, {1.0f, 0.3f, 0.2f});
  for (BuiltScene* built : {&all, &second}) add_lamp(*built, 1.0f, {0.2f, 0.4f, 1.0f});
  FrameRenderer renderer(*test_device(), kFormat, 1);
  FrameInputs inputs = seen_from_aside();
  const Uploaded one(all), a(first), b(second);
  const DrawnScene whole[] = {one.drawn()}, parts[] = {a.drawn(), b.drawn()};
  inputs.scenes = whole;
  const Pixels expected = draw(renderer, inputs);
  inputs.scenes = parts;
  EXPECT_EQ(draw(renderer, inputs), expected);
  inputs.scenes = std::span(parts).first(1);
  EXPECT_NE(draw(renderer, inputs), expected);
}

TEST_F(frame_inputs, each_slot_has_the_materials_of_its_own_frame) {
  BuiltScene built;
  built.add(square(2.0f), built.add_material(matte({1, 0, 0})));
  built.scene.properties.entries = {{{PropertyKind::base_color, 0}, 0, 4}};
  built.scene.properties.rest = {1, 0, 0, 1};
  FrameRenderer renderer(*test_device(), kFormat, 2);
  Uploaded shown(built, 2);
  const float colors[2][4] = {{0, 1, 0, 1}, {0, 0, 1, 1}};
  for (std::uint32_t slot = 0; slot < 2; ++slot) {
    FrameResult frame = built.frame();
    frame.properties = colors[slot];
    shown.show(slot, frame);
  }
  FrameInputs inputs = seen_from_aside();
  const DrawnScene drawn[] = {shown.drawn()};
  inputs.scenes = drawn;
  for (const std::uint32_t slot : {1u, 0u, 1u}) {
    inputs.slot = slot;
    const Pixels pixels = draw(renderer, inputs);
    const std::uint8_t* middle = &pixels[4 * (12 * 32 + 16)];
    EXPECT_GT(middle[1 + slot], middle[2 - slot] + 60) << slot;
  }
}

TEST_F(frame_inputs, pictures_of_another_width_or_height_are_those_of_a_fresh_renderer) {
  BuiltScene built = box_and_sphere_on_floor();
  add_lamp(built, 1.0f, {1.0f, 1.0f, 1.0f});
  const Uploaded shown(built);
  const DrawnScene drawn[] = {shown.drawn()};
  FrameInputs inputs = seen_from_aside();
  inputs.scenes = drawn;
  FrameRenderer used(*test_device(), kFormat, 1);
  for (const VkExtent2D extent : {VkExtent2D{32, 16}, {32, 24}, {20, 24}, {24, 20}}) {
    FrameRenderer fresh(*test_device(), kFormat, 1);
    EXPECT_EQ(draw(used, inputs, extent), draw(fresh, inputs, extent)) << extent.width << " x " << extent.height;
  }
}

}  // namespace
}  // namespace sinew::viewer
