// SPDX-License-Identifier: MIT
// Pictures of a tilted wall through each texture filter. The projection is parallel, so that the footprint of a pixel
// on the texture is the same everywhere, and exact.
#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "tests/reference/picture.h"
#include "tests/reference/shade.h"
#include "tests/reference/texture.h"
#include "tests/viewer/reference_picture.h"

namespace sinew::viewer {
namespace {

class filter_picture : public DeviceTest {};

constexpr int kWidth = 28, kHeight = 22;

View view_from(const glm::dvec3& eye) {
  View view = look_at(eye, {0.1, 0.0, 0.0}, 0.8, 0.05);
  view.half_height_m = 0.6;
  view.far_m = 9.0;
  return view;
}

RenderOptions options_of(Show show) {
  RenderOptions options = every_light();
  options.show = show;
  return options;
}

/// A wall that shows an image of random colours.
BuiltScene noisy_wall(std::uint32_t width, std::uint32_t height, Wrap wrap_u, Wrap wrap_v, float turn_rad = 0.0f) {
  BuiltScene built;
  Material material;
  material.unlit = material.double_sided = true;
  TextureUse& use = material.base_color_texture;
  use.texture = add_noise_texture(built, {.wrap_u = wrap_u, .wrap_v = wrap_v});
  Image& image = built.scene.images.back();
  image.width = width;
  image.height = height;
  const std::vector<std::uint8_t> few = image.rgba;
  image.rgba.resize(std::size_t{4} * width * height);
  for (std::size_t i = 0; i < image.rgba.size(); ++i)
    image.rgba[i] = static_cast<std::uint8_t>(few[i % few.size()] ^ (i / few.size() * 23 % 128));
  use.scale = {1.7f, 1.9f};
  use.offset = {-0.4f, -0.7f};
  use.rotation_rad = turn_rad;
  Primitive p = wall();
  built.add(p, built.add_material(material));
  return built;
}

/// The wall's transformed texture coordinates at the center of a pixel, and the pixel's footprint in the texture. NaN
/// beside the wall.
struct Seen {
  glm::dvec2 uv, texels;  ///< sides of the footprint
  double to_next;         ///< texels to the next pixel, in the row or in the column
};

Seen look(const BuiltScene& built, const View& view, int x, int y) {
  const FrameResult frame = built.frame();
  const RenderOptions options;
  const reference::PictureOf picture{built.scene, frame, view, options, kWidth, kHeight};
  const TextureUse& use = built.scene.materials[0].base_color_texture;
  const auto uv_at = [&](double px, double py) {
    const auto points = reference::surfaces_along(built.scene, frame, reference::sight_line(picture, px, py));
    return points.empty() ? glm::dvec2(NAN) : reference::transformed(use, points[0].uv[0]);
  };
  const glm::dvec2 uv = uv_at(x + 0.5, y + 0.5), dx = uv_at(x + 0.75, y + 0.5) - uv_at(x + 0.25, y + 0.5),
                   dy = uv_at(x + 0.5, y + 0.75) - uv_at(x + 0.5, y + 0.25);
  const glm::dvec2 size(built.scene.images[0].width, built.scene.images[0].height);
  const glm::dvec2 along = 2.0 * dx * size, down = 2.0 * dy * size;
  return {.uv = uv,
          .texels = {std::hypot(along.x, down.x), std::hypot(along.y, down.y)},
          .to_next = std::max(glm::length(along), glm::length(down))};
}

void expect_rip_map(const BuiltScene& built, const View& view) {
  const FloatPicture drawn =
      render_float(built, kWidth, kHeight, view, options_of(Show::color), {}, {}, nullptr, {}, {FilterKind::rip_map});
  int compared = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const Seen seen = look(built, view, x, y);
      if (!(std::abs(seen.texels.x + seen.texels.y) < 1e9)) continue;  // beside the wall, or on its edge
      ++compared;
      const glm::dvec4 texel =
          reference::rip_texel(built.scene, built.scene.materials[0].base_color_texture, seen.uv, seen.texels, true);
      for (int c = 0; c < 3; ++c)
        ASSERT_NEAR(static_cast<double>(drawn.at(x, y)[c]), reference::srgb_encoded(texel[c]), kDecodedBound)
            << "pixel " << x << ' ' << y << ", " << seen.texels.x << " x " << seen.texels.y << " texels";
    }
  EXPECT_GT(compared, kWidth * kHeight / 4);
}

TEST_F(filter_picture, rip_maps_mix_four_levels_as_wide_and_as_high_as_the_footprint) {
  for (const glm::dvec3& eye : {glm::dvec3(0.1, 0.0, 2.0), {2.0, 0.0, 0.5}, {0.1, 2.0, 0.3}, {1.5, 1.1, 0.4}})
    for (const float turn : {0.0f, 0.5f})
      expect_rip_map(noisy_wall(64, 64, Wrap::repeat, Wrap::repeat, turn), view_from(eye));
}

TEST_F(filter_picture, rip_maps_repeat_clamp_or_mirror_on_each_axis) {
  for (const Wrap u : {Wrap::repeat, Wrap::clamp_to_edge, Wrap::mirrored_repeat})
    for (const Wrap v : {Wrap::repeat, Wrap::clamp_to_edge, Wrap::mirrored_repeat})
      expect_rip_map(noisy_wall(32, 64, u, v), view_from({1.6, 0.6, 0.5}));
}

TEST_F(filter_picture, rip_maps_of_odd_sizes_and_single_rows) {
  for (const auto& [width, height] : {std::pair(13u, 21u), {1u, 16u}, {40u, 1u}, {1u, 1u}})
    expect_rip_map(noisy_wall(width, height, Wrap::repeat, Wrap::mirrored_repeat), view_from({1.6, 0.6, 0.5}));
}

/// How far a driver's level may be off.
constexpr double kLevelBound = 0.1;

TEST_F(filter_picture, mipmaps_mix_two_levels_by_the_texels_to_the_next_pixel) {
  for (const glm::dvec3& eye : {glm::dvec3(0.1, 0.0, 2.0), {2.0, 0.0, 0.5}, {0.1, 2.0, 0.3}, {1.5, 1.1, 0.4}})
    for (const auto& [width, height] : {std::pair(64u, 64u), {16u, 64u}}) {
      const BuiltScene built = noisy_wall(width, height, Wrap::repeat, Wrap::mirrored_repeat, 0.5f);
      const View view = view_from(eye);
      const FloatPicture drawn = render_float(built, kWidth, kHeight, view, options_of(Show::color), {}, {}, nullptr,
                                              {}, {FilterKind::trilinear});
      const TextureUse& use = built.scene.materials[0].base_color_texture;
      int compared = 0;
      for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
          const Seen seen = look(built, view, x, y);
          if (!(std::abs(seen.texels.x + seen.texels.y) < 1e9)) continue;
          ++compared;
          glm::dvec3 least(1.0), most(0.0);
          for (const double off : {-kLevelBound, 0.0, kLevelBound}) {
            const double level = reference::mip_level(built.scene, use, seen.to_next * std::exp2(off));
            const glm::dvec3 texel(reference::mip_texel(built.scene, use, seen.uv, level, true));
            least = glm::min(least, texel);
            most = glm::max(most, texel);
          }
          for (int c = 0; c < 3; ++c) {
            const auto shown = static_cast<double>(drawn.at(x, y)[c]);
            ASSERT_GT(shown, reference::srgb_encoded(least[c]) - kDecodedBound) << "pixel " << x << ' ' << y;
            ASSERT_LT(shown, reference::srgb_encoded(most[c]) + kDecodedBound) << "pixel " << x << ' ' << y;
          }
        }
      EXPECT_GT(compared, kWidth * kHeight / 4);
    }
}

TEST_F(filter_picture, the_level_is_that_of_the_larger_side_of_the_footprint_or_of_each_side_in_rip_maps) {
  const BuiltScene built = noisy_wall(64, 64, Wrap::repeat, Wrap::repeat);
  const View view = view_from({0.1, 2.0, 0.3});
  const Seen seen = look(built, view, kWidth / 2, kHeight / 2);
  ASSERT_GT(seen.texels.y, 3.0 * seen.texels.x);
  const auto level_of = [&](const TextureFilter& filter) {
    const FloatPicture drawn =
        render_float(built, kWidth, kHeight, view, options_of(Show::level), {}, {}, nullptr, {}, filter);
    return glm::dvec3(drawn.at(kWidth / 2, kHeight / 2)) * 10.0;
  };
  const glm::dvec2 sides = glm::dvec2(std::log2(seen.texels.x), std::log2(seen.texels.y));
  const glm::dvec3 rip = level_of({FilterKind::rip_map}), mip = level_of({FilterKind::trilinear});
  EXPECT_NEAR(rip.x, std::max(sides.x, 0.0), 0.01);
  EXPECT_NEAR(rip.y, sides.y, 0.01);
  EXPECT_NEAR(mip.x, sides.y, kLevelBound);
  EXPECT_EQ(mip.x, mip.y);
  EXPECT_EQ(rip.z + mip.z, 0.0);
  EXPECT_EQ(level_of({FilterKind::bilinear}), glm::dvec3(0.0));
  const double many = level_of({FilterKind::anisotropic, 16}).x;
  EXPECT_TRUE(test_device()->max_anisotropy() < 16.0f || many < sides.y - 1.0) << many;
}

TEST_F(filter_picture, the_level_shown_is_that_of_every_pixel) {
  const auto drawn = [](const BuiltScene& built, const View& view, FilterKind kind) {
    return render_float(built, kWidth, kHeight, view, options_of(Show::level), {}, {}, nullptr, {}, {kind});
  };
  for (const glm::dvec3& eye : {glm::dvec3(0.1, 0.0, 2.0), {0.1, 2.0, 0.3}, {1.5, 1.1, 0.4}})
    for (const auto& [width, height] : {std::pair(64u, 64u), {16u, 128u}}) {
      const BuiltScene built = noisy_wall(width, height, Wrap::repeat, Wrap::repeat, 0.4f);
      const View view = view_from(eye);
      const FloatPicture rip = drawn(built, view, FilterKind::rip_map), mip = drawn(built, view, FilterKind::trilinear);
      const TextureUse& use = built.scene.materials[0].base_color_texture;
      double largest = 0.0;
      for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
          const Seen seen = look(built, view, x, y);
          if (!(std::abs(seen.texels.x + seen.texels.y) < 1e9)) continue;
          const glm::dvec2 levels = reference::rip_levels(built.scene, use, seen.texels);
          const double level = reference::mip_level(built.scene, use, seen.to_next);
          const glm::dvec3 shown = glm::dvec3(rip.at(x, y)) * 10.0, shown_mip = glm::dvec3(mip.at(x, y)) * 10.0;
          ASSERT_LT(glm::length(shown - glm::dvec3(levels, 0.0)), 0.02) << "pixel " << x << ' ' << y;
          ASSERT_NEAR(shown_mip.x, level, kLevelBound) << "pixel " << x << ' ' << y;
          largest = std::max(largest, level);
        }
      EXPECT_GT(largest, 0.5) << "some levels are seen";
    }
}

TEST_F(filter_picture, samplers_of_files_are_anisotropic_on_graphics_cards_alone) {
  const BuiltScene built = noisy_wall(64, 64, Wrap::repeat, Wrap::repeat);
  const auto drawn = [&](const TextureFilter& filter) {
    return render_float(built, kWidth, kHeight, view_from({0.1, 2.0, 0.3}), options_of(Show::color), {}, {}, nullptr,
                        {}, filter)
        .pixels;
  };
  const bool software = test_device()->is_software();
  EXPECT_EQ(drawn({}),
            drawn(software ? TextureFilter{FilterKind::trilinear} : TextureFilter{FilterKind::anisotropic, 8}));
  EXPECT_TRUE(!software || drawn({}) != drawn({FilterKind::anisotropic, 8}));
}

TEST_F(filter_picture, the_level_is_blue_where_there_is_no_texture_and_grey_beside_the_scene) {
  BuiltScene built;
  built.add(wall(), built.add_material(plain()));
  const FloatPicture drawn = render_float(built, 64, 8, view_from({0.1, 0.0, 2.0}), options_of(Show::level));
  EXPECT_EQ(glm::vec3(drawn.at(32, 4)), glm::vec3(0.0f, 0.0f, 0.5f));
  EXPECT_EQ(glm::vec3(drawn.at(0, 4)), glm::vec3(0.5f));
}

/// A wall of green leaves, which cover a third of it, between transparent magenta.
BuiltScene leaves(AlphaMode mode) {
  BuiltScene built;
  Material material;
  material.unlit = material.double_sided = true;
  material.alpha_mode = mode;
  material.base_color_texture.texture = add_noise_texture(built, {});
  material.base_color_texture.scale = {5.0f, 5.0f};
  Image& image = built.scene.images.back();
  image.width = image.height = 64;
  image.rgba.clear();
  for (int i = 0; i < 64 * 64; ++i) {
    const int x = i % 64 % 8, y = i / 64 % 8, across = (i / 8 * 5 + i / 512 * 3) % 4;
    const bool leaf = (x - 4) * (x - 4) + (y - 4) * (y - 4) < 4 + 3 * across;
    for (const int code : {leaf ? 30 : 255, leaf ? 160 : 0, leaf ? 20 : 255, leaf ? 255 : 0})
      image.rgba.push_back(static_cast<std::uint8_t>(code));
  }
  Primitive p = wall();
  built.add(p, built.add_material(material));
  return built;
}

TEST_F(filter_picture, distant_leaves_cover_as_much_as_near_ones_and_have_no_colour_of_what_is_transparent) {
  const auto drawn = [](const BuiltScene& built, double half_height_m, bool smooth, const TextureFilter& filter) {
    View view = look_at({0, 0, 3}, {0, 0, 0}, 0.8, 0.1);
    view.half_height_m = half_height_m;
    view.far_m = 9.0;
    RenderOptions options = options_of(Show::color);
    options.transparent_background = true;
    options.smooth_edges = smooth;
    const FloatPicture picture = render_float(built, kWidth, kHeight, view, options, {}, {}, nullptr, {}, filter);
    glm::dvec4 sum(0.0);  // premultiplied, linear
    for (const glm::vec4& pixel : picture.pixels)
      for (int c = 0; c < 4; ++c)
        sum[c] += static_cast<double>(pixel.a) *
                  (c < 3 ? reference::srgb_decoded(static_cast<double>(pixel[c])) : 1.0 / (kWidth * kHeight));
    return sum;
  };
  for (const AlphaMode mode : {AlphaMode::mask, AlphaMode::blend})
    for (const bool smooth : {false, true})
      for (const FilterKind kind : {FilterKind::trilinear, FilterKind::rip_map}) {
        const BuiltScene built = leaves(mode);
        const glm::dvec4 near = drawn(built, 0.08, smooth, {kind}), far = drawn(built, 0.35, smooth, {kind});
        EXPECT_NEAR(far.a, near.a, 0.1) << "smooth " << smooth;
        EXPECT_GT(far.a, 0.2);
        EXPECT_LT(far.r, 0.05 * far.g) << "magenta shows";
      }
}

}  // namespace
}  // namespace sinew::viewer
