// SPDX-License-Identifier: MIT
// Draws small scenes: alpha modes, winding, topologies, textures, lines, large coordinates.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "samples/showcase/shapes.h"
#include "tests/viewer/device_fixture.h"

namespace sinew::viewer {
namespace {

class drawing : public DeviceTest {};

constexpr int kSize = 32;

/// A square that faces +z and fills the middle half of the picture when seen from (0, 0, 2).
Primitive facing_square(float half_size = 0.5f, float z = 0.0f) {
  Primitive p = square(half_size);
  for (std::size_t i = 0; i < 4; ++i) p.positions[i] = {p.positions[i].x, -p.positions[i].z, z};
  p.normals.assign(4, {0.0f, 0.0f, 1.0f});
  return p;
}

Material unlit(const glm::vec4& color, AlphaMode mode = AlphaMode::opaque) {
  Material material;
  material.base_color = color;
  material.unlit = true;
  material.alpha_mode = mode;
  return material;
}

View front_view() { return look_at({0.0, 0.0, 2.0}, {0.0, 0.0, 0.0}, 2.0 * std::atan(0.5), 0.05); }

FloatPicture draw(const BuiltScene& built, RenderOptions options = {}) {
  options.transparent_background = true;
  return render_float(built, kSize, kSize, front_view(), options);
}

glm::vec4 middle(const FloatPicture& picture) { return picture.at(kSize / 2, kSize / 2); }

std::size_t covered(const FloatPicture& picture) {
  return static_cast<std::size_t>(
      std::count_if(picture.pixels.begin(), picture.pixels.end(), [](const glm::vec4& p) { return p.a > 0.0f; }));
}

TEST_F(drawing, transparent_background_has_alpha_zero_exactly_where_nothing_was_drawn) {
  BuiltScene built;
  built.add(facing_square(), built.add_material(unlit({0.5f, 0.5f, 0.5f, 1.0f})));
  for (const bool occlusion : {true, false}) {
    RenderOptions options;
    options.ao.on = occlusion;
    const FloatPicture picture = draw(built, options);
    EXPECT_EQ(covered(picture), 16u * 16u);
    EXPECT_EQ(picture.at(0, 0), glm::vec4(0.0f));
    EXPECT_EQ(middle(picture).a, 1.0f);
  }
}

TEST_F(drawing, opaque_background_is_the_colour_that_was_asked_for) {
  BuiltScene built;
  RenderOptions options;
  options.background = {0.25f, 0.5f, 0.75f};
  const auto off = [&] {
    const FloatPicture picture = render_float(built, kSize, kSize, front_view(), options);
    return glm::length(picture.at(3, 5) - glm::vec4(0.25f, 0.5f, 0.75f, 1.0f));
  };
  EXPECT_LT(off(), 1e-3f);
  options.backdrop = Backdrop::sharp;
  EXPECT_GT(off(), 0.05f) << "the environment is behind";
  options.lighting.environment_intensity = 0.0f;
  EXPECT_LT(off(), 1e-3f) << "there is no light to show";
}

TEST_F(drawing, one_sided_faces_show_their_front_only_and_mirrored_ones_their_other_winding) {
  Affine mirror;  // x -> -x reverses the winding
  mirror.row[0].x = -1.0f;
  for (const bool mirrored : {false, true})
    for (const bool flagged : {false, true}) {
      BuiltScene built;
      built.add(facing_square(), built.add_material(matte({1, 1, 1})), mirrored ? mirror : Affine{}, flagged);
      EXPECT_EQ(covered(draw(built)) > 0, mirrored == flagged) << mirrored << flagged;
    }
}

TEST_F(drawing, N22_mirrored_and_flattened_meshes_keep_outward_normals) {
  Affine mirror, flat;
  mirror.row[0].x = -1.0f;
  flat.row[2].z = 0.0f;
  RenderOptions options;
  options.show = Show::normals;
  for (const Affine& m : {mirror, flat}) {
    BuiltScene built;
    built.add(facing_square(), built.add_material(matte({1, 1, 1})), m, m.row[0].x < 0.0f);
    EXPECT_LT(glm::length(glm::vec3(middle(draw(built, options))) - glm::vec3(0.5f, 0.5f, 1.0f)), 1e-3f);
  }
}

TEST_F(drawing, G48_relief_keeps_its_direction_where_a_mesh_is_mirrored) {
  const auto lit = [](unsigned char up, float mirror) {
    BuiltScene built;
    built.scene.images.push_back(
        {"relief", 1, 1, {128, up, 218, 255}, ""});  // leans along the bitangent, 45 degrees up or down
    built.scene.textures.push_back({0, {}});
    Material material = matte({0.6f, 0.6f, 0.6f});
    material.normal_texture.texture = 0;
    Primitive p = facing_square();
    p.tangents.assign(4, {1.0f, 0.0f, 0.0f, 1.0f});
    Affine m;
    m.row[0].x = mirror;
    built.add(p, built.add_material(material), m, mirror < 0.0f);
    return middle(draw(built));
  };
  EXPECT_GT(glm::length(lit(218, 1.0f) - lit(38, 1.0f)), 0.02f) << "the relief is seen";
  EXPECT_LT(glm::length(lit(218, -1.0f) - lit(218, 1.0f)), 2e-3f);
  EXPECT_LT(glm::length(lit(38, -1.0f) - lit(38, 1.0f)), 2e-3f);
}

TEST_F(drawing, relief_of_a_mesh_without_tangents_is_that_of_its_texture_coordinates) {
  const auto lit = [](bool tangents, unsigned char right, unsigned char up, float mirror, bool back) {
    BuiltScene built;
    built.scene.images.push_back({"relief", 1, 1, {right, up, 218, 255}, ""});
    built.scene.textures.push_back({0, {}});
    Material material = matte({0.6f, 0.6f, 0.6f});
    material.normal_texture.texture = 0;
    material.double_sided = true;
    Primitive p = facing_square();
    if (tangents) p.tangents.assign(4, {1.0f, 0.0f, 0.0f, 1.0f});
    Affine m;
    m.row[0].x = mirror;
    if (back) {
      m.row[0].x *= -1.0f;
      m.row[2].z = -1.0f;
    }
    built.add(p, built.add_material(material), m, mirror < 0.0f);
    return middle(draw(built));
  };
  EXPECT_GT(glm::length(lit(false, 218, 128, 1.0f, false) - lit(false, 38, 128, 1.0f, false)), 0.02f)
      << "the relief is seen";
  for (const float mirror : {1.0f, -1.0f})
    for (const bool back : {false, true})
      EXPECT_LT(glm::length(lit(true, 200, 60, mirror, back) - lit(false, 200, 60, mirror, back)), 2e-3f)
          << mirror << back;
}

TEST_F(drawing, blended_surfaces_take_no_occlusion_from_what_is_behind_them) {
  BuiltScene built;
  const std::uint32_t wall = built.add_material(unlit({0.5f, 0.5f, 0.5f, 1}));  // occlusion does not show on it
  built.add(facing_square(0.8f), wall);
  Affine floor;  // a square perpendicular to the wall, towards the viewer
  floor.row[1] = {0, 0, 1, -0.1f};
  floor.row[2] = {0, -1, 0, 0.4f};
  built.add(facing_square(0.4f), wall, floor);
  Material blends = matte({0.7f, 0.7f, 0.7f}), transmits = blends;
  blends.base_color.a = 0.5f;
  blends.alpha_mode = AlphaMode::blend;
  transmits.transmission.factor = 0.5f;
  const std::uint32_t glass = built.add_material(blends);
  built.add(facing_square(0.8f, 0.05f), glass);
  RenderOptions with, without, ao;
  with.ao.radius_m = ao.ao.radius_m = 1.0f;
  without.ao.on = false;
  ao.show = Show::ao;
  EXPECT_LT(middle(draw(built, ao)).r, 0.95f) << "the wall behind is occluded";
  for (const Material& material : {blends, transmits})
    for (const Transparency how : {Transparency::sorted, Transparency::weighted}) {
      built.scene.materials[glass] = material;
      with.transparency = without.transparency = how;
      EXPECT_LT(glm::length(middle(draw(built, with)) - middle(draw(built, without))), 1e-4f);
    }
}

TEST_F(drawing, double_sided_backs_are_lit_from_behind) {
  BuiltScene built;
  Material material = matte({1, 1, 1});
  material.double_sided = true;
  Affine turned;  // about y by 180 degrees
  turned.row[0].x = turned.row[2].z = -1.0f;
  built.add(facing_square(), built.add_material(material), turned);
  RenderOptions options;
  options.show = Show::normals;
  EXPECT_LT(glm::length(glm::vec3(middle(draw(built, options))) - glm::vec3(0.5f, 0.5f, 1.0f)), 1e-3f);
}

TEST_F(drawing, alpha_mask_cuts_holes_with_and_without_the_prepass) {
  for (const float alpha : {0.49f, 0.51f})
    for (const bool occlusion : {true, false}) {
      BuiltScene built;
      built.add(facing_square(), built.add_material(unlit({1, 1, 1, alpha}, AlphaMode::mask)));
      RenderOptions options;
      options.ao.on = occlusion;
      EXPECT_EQ(covered(draw(built, options)) > 0, alpha > 0.5f);
    }
}

TEST_F(drawing, blended_surfaces_mix_from_far_to_near_whatever_their_order) {
  const auto near_over_far = [](bool near_first) {
    BuiltScene built;
    const std::uint32_t red = built.add_material(unlit({0.6f, 0, 0, 0.5f}, AlphaMode::blend));
    const std::uint32_t green = built.add_material(unlit({0, 0.6f, 0, 0.5f}, AlphaMode::blend));
    const Primitive near_square = facing_square(0.5f, 0.3f), far_square = facing_square(0.8f, -0.3f);
    built.add(near_first ? near_square : far_square, near_first ? red : green);
    built.add(near_first ? far_square : near_square, near_first ? green : red);
    return middle(draw(built));
  };
  const glm::vec4 a = near_over_far(true), b = near_over_far(false);
  EXPECT_EQ(a, b);
  EXPECT_NEAR(a.a, 0.75f, 1e-3f);
  // premultiplied: red 0.5 * 0.6 over green 0.25 * 0.6, of coverage 0.75
  EXPECT_GT(a.r, a.g);
  EXPECT_NEAR(std::pow((a.g + 0.055f) / 1.055f, 2.4f), 0.2f, 3e-3f);
  EXPECT_NEAR(std::pow((a.r + 0.055f) / 1.055f, 2.4f), 0.4f, 3e-3f);
}

TEST_F(drawing, blended_surfaces_at_one_distance_lie_over_each_other_in_the_order_of_the_scene) {
  for (const bool red_first : {true, false}) {
    BuiltScene built;
    const std::uint32_t red = built.add_material(unlit({0.6f, 0, 0, 0.5f}, AlphaMode::blend));
    const std::uint32_t green = built.add_material(unlit({0, 0.6f, 0, 0.5f}, AlphaMode::blend));
    built.add(facing_square(), red_first ? red : green);
    built.add(facing_square(), red_first ? green : red);
    const glm::vec4 seen = middle(draw(built));
    EXPECT_EQ(seen.r < seen.g, red_first) << "the second lies over the first";
    EXPECT_NE(seen.r, seen.g);
  }
}

TEST_F(drawing, blended_surfaces_hide_behind_opaque_ones_and_do_not_hide_others) {
  BuiltScene built;
  const std::uint32_t glass = built.add_material(unlit({0, 0, 1, 0.5f}, AlphaMode::blend));
  built.add(facing_square(0.5f, -0.2f), glass);
  built.add(facing_square(0.3f), built.add_material(unlit({0.5f, 0, 0, 1})));
  EXPECT_EQ(middle(draw(built)).b, 0.0f);
  EXPECT_NEAR(draw(built).at(kSize / 2 - 6, kSize / 2).a, 0.5f, 1e-3f);
}

TEST_F(drawing, points_and_lines_are_drawn_unlit) {
  for (const Topology topology : {Topology::points, Topology::lines}) {
    BuiltScene built;
    Primitive p;
    p.topology = topology;
    p.positions = {{-0.4f, 0.01f, 0.0f}, {0.4f, 0.01f, 0.0f}};
    p.indices = {0, 1};
    built.add(p, built.add_material(matte({0.0f, 0.5f, 0.0f})));
    const FloatPicture picture = draw(built);
    EXPECT_GT(covered(picture), topology == Topology::points ? 1u : 10u);
    for (const glm::vec4& pixel : picture.pixels) {
      if (pixel.a == 0.0f) continue;
      EXPECT_NEAR(pixel.g, 0.735f, 0.01f);  // sRGB of 0.5
    }
  }
}

TEST_F(drawing, vertex_colours_and_textures_multiply_the_base_colour) {
  BuiltScene built;
  Image image;
  image.width = image.height = 2;
  image.rgba = {255, 0, 128, 255, 255, 255, 128, 255, 255, 0, 128, 255, 255, 255, 128, 255};
  built.scene.images.push_back(image);
  built.scene.textures.push_back({0, {.magnify = Filter::nearest, .minify = Filter::nearest, .use_mipmaps = false}});
  Material material = unlit({0.5f, 1, 1, 1});
  material.base_color_texture.texture = 0;
  Primitive p = facing_square();
  p.colors.assign(4, {1.0f, 1.0f, 0.5f, 1.0f});
  built.add(p, built.add_material(material));
  const FloatPicture picture = draw(built);
  const glm::vec4 left = picture.at(kSize / 2 - 4, kSize / 2), right = picture.at(kSize / 2 + 4, kSize / 2);
  EXPECT_LT(left.g, 0.02f);
  EXPECT_GT(right.g, 0.8f);
  EXPECT_NEAR(left.r, 0.735f, 0.03f);                                     // 0.5 linear
  EXPECT_NEAR(right.b, 0.735f * 0.502f / std::sqrt(2.0f) + 0.0f, 0.12f);  // (128 decoded) / 2
}

TEST_F(drawing, G60_texture_transforms_offset_after_rotation_after_scale) {
  BuiltScene built;
  Image image;  // left half black, right half white
  image.width = image.height = 64;
  image.rgba.resize(4 * 64 * 64);
  for (std::size_t i = 0; i < image.rgba.size(); ++i) image.rgba[i] = i / 4 % 64 < 32 ? 0 : 255;
  built.scene.images.push_back(image);
  built.scene.textures.push_back({0, {}});
  Material material = unlit({1, 1, 1, 1});
  material.base_color_texture.texture = 0;
  // u' = v, v' = 1 - u: a quarter turn counter-clockwise, moved back into the image
  material.base_color_texture.rotation_rad = std::numbers::pi_v<float> / 2.0f;
  material.base_color_texture.offset = {0.0f, 1.0f};
  built.add(facing_square(), built.add_material(material));
  const FloatPicture picture = draw(built);
  EXPECT_LT(picture.at(kSize / 2, kSize / 2 - 5).r, 0.1f);  // v small at the top: the black half
  EXPECT_GT(picture.at(kSize / 2, kSize / 2 + 5).r, 0.8f);
}

TEST_F(drawing, G66_a_missing_image_shows_a_magenta_and_black_board) {
  BuiltScene built;
  Image image;
  image.missing_reason = "not found";
  built.scene.images.push_back(image);
  built.scene.textures.push_back({0, {.magnify = Filter::nearest, .minify = Filter::nearest, .use_mipmaps = false}});
  Material material = unlit({0.6f, 0.6f, 0.6f, 1});
  material.base_color_texture.texture = 0;
  built.add(facing_square(), built.add_material(material));
  const FloatPicture picture = draw(built);
  int magenta = 0, black = 0;
  for (const glm::vec4& p : picture.pixels) {
    if (p.a == 0.0f) continue;
    magenta += p.r > 0.5f && p.g < 0.1f && p.b > 0.5f;
    black += p.r < 0.1f && p.g < 0.1f && p.b < 0.1f;
  }
  EXPECT_EQ(magenta, 128);
  EXPECT_EQ(black, 128);
}

TEST_F(drawing, G66_missing_data_textures_are_left_out) {
  const auto lit = [](bool with_missing) {
    BuiltScene built;
    Image image;
    image.missing_reason = "not found";
    built.scene.images.push_back(image);
    built.scene.textures.push_back({0, {}});
    Material material = matte({0.6f, 0.6f, 0.6f});
    if (with_missing)
      material.normal_texture.texture = material.metallic_roughness_texture.texture =
          material.occlusion_texture.texture = 0;
    Primitive p = facing_square();
    p.tangents.assign(4, {1.0f, 0.0f, 0.0f, 1.0f});
    built.add(p, built.add_material(material));
    return draw(built);
  };
  EXPECT_EQ(lit(true).pixels, lit(false).pixels);
}

TEST_F(drawing, flat_normals_come_from_the_deformed_shape) {
  BuiltScene built;
  Primitive p = facing_square();
  p.flat_normals = true;
  const std::uint32_t instance = built.add(p, built.add_material(matte({1, 1, 1})));
  std::vector<glm::vec3> tilted = p.positions;  // by 45 degrees about x; the stored normals are not changed
  for (glm::vec3& v : tilted) v.z = v.y;
  built.deform(instance, tilted, p.normals);
  RenderOptions options;
  options.show = Show::normals;
  const float s = std::sqrt(0.5f);
  EXPECT_LT(glm::length(glm::vec3(middle(draw(built, options))) * 2.0f - 1.0f - glm::vec3(0.0f, -s, s)), 3e-3f);
}

TEST_F(drawing, N25_a_mesh_ten_kilometres_out_does_not_shake) {
  BuiltScene near_scene, far_scene;
  const glm::vec3 out(16384.0f, 0.0f, 16384.0f);  // exact in float, so that the scene itself is the same
  near_scene.add(showcase::sphere({0, 0, 0}, 0.6f, 16, 8), near_scene.add_material(matte({1, 1, 1})));
  far_scene.add(showcase::sphere({0, 0, 0}, 0.6f, 16, 8), far_scene.add_material(matte({1, 1, 1})), translation(out));
  const View near_view = look_at({0.1, 0.2, 2.0}, {0, 0, 0}, 0.9, 0.05);
  const View far_view = look_at(glm::dvec3(out) + glm::dvec3(0.1, 0.2, 2.0), glm::dvec3(out), 0.9, 0.05);
  const FloatPicture a = render_float(near_scene, kSize, kSize, near_view, {}),
                     b = render_float(far_scene, kSize, kSize, far_view, {});
  for (std::size_t i = 0; i < a.pixels.size(); ++i) EXPECT_LT(glm::length(a.pixels[i] - b.pixels[i]), 2e-3f) << i;
}

TEST_F(drawing, overlay_lines_lie_over_the_picture_and_the_hook_runs_inside_the_last_pass) {
  BuiltScene built;
  built.add(facing_square(), built.add_material(unlit({0, 0, 0, 1})));
  const LineVertex line[2] = {{{-0.4f, 0.01f, -0.3f}, 0xff00ff00u},
                              {{0.4f, 0.01f, -0.3f}, 0xff00ff00u}};  // behind the square
  FrameInputs extras;
  extras.lines = line;
  int called = 0;
  extras.overlay = [&](VkCommandBuffer) { ++called; };
  const FloatPicture picture = render_float(built, kSize, kSize, front_view(), {}, extras);
  EXPECT_EQ(called, 1);
  const auto green = std::count_if(picture.pixels.begin(), picture.pixels.end(),
                                   [](const glm::vec4& p) { return p.g > 0.3f && p.r == 0.0f; });
  EXPECT_GT(green, 8) << "behind the square it is fainter";
}

TEST_F(drawing, every_combination_of_modes_is_silent_under_validation) {
  BuiltScene built = box_and_sphere_on_floor();
  Material glass = matte({0.5f, 0.8f, 1.0f});
  glass.base_color.a = 0.4f;
  glass.alpha_mode = AlphaMode::blend;
  glass.double_sided = true;
  built.add(showcase::sphere({0, 1.5f, 0}, 0.5f), built.add_material(glass));
  glass.alpha_mode = AlphaMode::opaque;
  glass.transmission.factor = 0.7f;
  glass.sheen = {.color = {0.3f, 0.2f, 0.1f}, .roughness = 0.5f};
  glass.clearcoat.factor = 0.5f;
  built.add(showcase::sphere({1, 1.2f, 0}, 0.4f), built.add_material(glass));
  glass.roughness = 0.0f;
  built.add(showcase::sphere({1, 0.2f, 0}, 0.2f), built.add_material(glass));
  built.add(showcase::sphere({-1, 1.2f, 0}, 0.2f), built.add_material(unlit({0, 1, 0, 1})));
  for (const Show show : {Show::color, Show::ao, Show::normals, Show::depth, Show::level})
    for (const bool occlusion : {true, false})
      for (const bool blur : {true, false}) {
        RenderOptions options;
        options.show = show;
        options.transparency = occlusion == blur ? Transparency::weighted : Transparency::sorted;
        options.ao.on = occlusion;
        options.ao.blur = blur;
        options.smooth_edges = occlusion;
        options.backdrop = blur ? Backdrop::blurred : occlusion ? Backdrop::sharp : Backdrop::plain;
        const FloatPicture picture = render_float(built, 133, 67, look_at({3, 3, 5}, {0, 0, 0}, 0.8, 0.05), options);
        float farthest = 0.0f;
        for (const glm::vec4& pixel : picture.pixels)
          farthest = std::max(farthest, glm::length(pixel - picture.pixels[0]));
        EXPECT_TRUE(std::isfinite(farthest));
        EXPECT_TRUE(farthest > 0.05f || (show == Show::ao && !occlusion)) << "a picture in every mode";
      }
  if (!test_device()->validation_active()) GTEST_SKIP() << "silent, but the validation layer is not installed";
}

}  // namespace
}  // namespace sinew::viewer
