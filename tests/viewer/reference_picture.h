// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <span>

#include "tests/viewer/device_fixture.h"

namespace sinew::viewer {

/// Tolerances for comparing a picture with the reference renderer.
struct PictureBounds {
  int width = 24, height = 20;
  double bound =
      0.001;  ///< per channel, a quarter of a step of 8 bits. Light is stored as half floats between the passes
  double sharp = 0.7;  ///< minimum fraction of pixels whose range is narrower than 5 bounds
};

/// Draws the scene and compares each pixel with the reference renderer (tests/reference/picture.h). The reference
/// samples five rays per pixel: the center and 1/32 pixel around it. Each channel must lie within the range of these
/// samples, widened by the bound, so a pixel on an edge may fall on either side.
/// in   visibility   [width * height] ambient visibility for the reference; empty = 1
///      ambient  gradient of the environment in `options`
void expect_reference_picture(const BuiltScene& built, const View& view, const RenderOptions& options,
                              const PictureBounds& bounds = {}, std::span<const double> visibility = {},
                              const Gradient& ambient = {});

/// Only the lights of the scene: no environment, no occlusion.
RenderOptions only_scene_lights();

/// All light, without occlusion.
RenderOptions every_light();

/// Only environment light.
RenderOptions only_ambient_light();

/// A wall in the plane z = 0 that faces +z: 2.4 m wide and high, with tangents and two sets of texture coordinates.
Primitive wall();

/// A plain, rather rough, non-metallic material.
Material plain();

/// A wall of this material under a lamp near it and a directional light.
BuiltScene lit_wall(BuiltScene built, const Material& material, const Primitive& primitive = wall(),
                    const Affine& world_from_wall = {}, bool mirrored = false);

/// A view from the front and the side; the wall fills the picture.
View view_of_wall();

/// Bound for pictures of sRGB textures: Mesa's software driver decodes with a polynomial approximation.
inline constexpr double kDecodedBound = 0.006;

/// Relative tolerance of the white furnace test, in linear light.
inline constexpr float kFurnaceBound = 0.01f;

/// Adds an image of 8 x 8 random colours and alphas, and a texture that shows it without filter. Returns the texture.
std::uint32_t add_noise_texture(BuiltScene& built,
                                const Sampler& sampler = {
                                    .magnify = Filter::nearest, .minify = Filter::nearest, .use_mipmaps = false});

/// Texture references without a texture: both coordinate sets, each without and with a transform.
std::array<TextureUse, 4> placed_textures();

/// A texture of one colour.
std::uint32_t add_plain_texture(BuiltScene& built, const std::array<std::uint8_t, 4>& rgba);

/// A light of the scene at `position` that shines along `direction`.
void add_light_at(BuiltScene& built, const Light& light, const glm::vec3& position, const glm::vec3& direction);

}  // namespace sinew::viewer
