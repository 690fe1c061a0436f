// SPDX-License-Identifier: MIT
// Each deformed attribute replaces the static one, alone and together with all others.
#include "tests/viewer/reference_picture.h"
#include "viewer/app/headless.h"

namespace sinew::viewer {
namespace {

class deformed_attributes : public DeviceTest {};

/// A wall that differs from wall() in all attributes except texture coordinates.
Primitive moved_wall() {
  Primitive p = wall();
  p.positions = {{-0.9f, -0.8f, 0.1f}, {1.0f, -0.9f, 0.0f}, {0.8f, 0.9f, -0.1f}, {-0.8f, 1.0f, 0.2f}};
  p.normals = {{0.3f, 0.0f, 0.954f}, {0.0f, 0.2f, 0.98f}, {-0.3f, 0.0f, 0.954f}, {0.0f, -0.2f, 0.98f}};
  p.tangents.assign(4, {0.0f, 1.0f, 0.0f, -1.0f});
  p.colors = {{0.9f, 0.2f, 0.5f, 1}, {0.3f, 0.9f, 0.4f, 1}, {0.8f, 0.6f, 0.1f, 1}, {0.2f, 0.4f, 0.9f, 1}};
  return p;
}

BuiltScene wall_of(const Primitive& primitive) {
  BuiltScene built;
  Material material = plain();
  material.normal_texture.texture = add_plain_texture(built, {196, 90, 220, 255});
  material.normal_texture.texcoord = 0;
  return lit_wall(std::move(built), material, primitive);
}

TEST_F(deformed_attributes, are_drawn_in_place_of_those_of_the_mesh) {
  Primitive own = wall();
  own.colors.assign(4, glm::vec4(0.5f, 0.6f, 0.7f, 1.0f));
  const Primitive moved = moved_wall();
  for (int which = 0; which < 16; ++which) {
    if (which != 15 && (which & (which - 1)) != 0) continue;  // none, each alone, and all
    Primitive expected = own;
    DeformedPrimitive deformed;
    if (which & 1) deformed.positions = expected.positions = moved.positions;
    if (which & 2) deformed.normals = expected.normals = moved.normals;
    if (which & 4) deformed.tangents = expected.tangents = moved.tangents;
    if (which & 8) deformed.colors = expected.colors = moved.colors;
    const BuiltScene mesh = wall_of(own), fixed = wall_of(expected);
    FrameResult frame = mesh.frame();
    frame.primitives = {&deformed, 1};
    const auto picture_of = [&](const BuiltScene& built, const FrameResult& result) {
      Headless renderer(*test_device(), built.scene, 24, 20);
      return renderer.render(result, view_of_wall(), every_light()).rgba;
    };
    const auto drawn = picture_of(mesh, frame);
    EXPECT_EQ(drawn, picture_of(fixed, fixed.frame())) << which;
    EXPECT_EQ(drawn == picture_of(mesh, mesh.frame()), which == 0) << which;
  }
}

}  // namespace
}  // namespace sinew::viewer
