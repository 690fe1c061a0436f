// SPDX-License-Identifier: MIT
#include "viewer/passes/picture_modes.h"

#include <algorithm>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace sinew::viewer {
namespace {

/// The live plan's text of one mode: "on" or "off", the count if any, and the reason.
std::string told(std::string_view name, const FrameNeeds& needs, const RenderOptions& options = {},
                 const TextureFilter& filter = {}) {
  for (const PictureMode& mode : describe_modes(needs, options, filter))
    if (mode.mode == name)
      return (mode.runs ? "on " : "off ") + (mode.count > 0 ? std::to_string(mode.count) + " " : "") +
             std::string(mode.reason);
  return "no such mode";
}

RenderOptions with(ToneCurve curve, Backdrop backdrop = Backdrop::plain) {
  RenderOptions options;
  options.lighting.tone_curve = curve;
  options.backdrop = backdrop;
  return options;
}

const FrameNeeds kPicture{.opaque = true}, kBuffer{.opaque = true, .smooth_edges = true, .show = Show::normals},
    kGooch{.opaque = true, .gooch = true};

TEST(picture_modes, tell_samples_a_pixel) {
  EXPECT_EQ(told("samples", {.opaque = true, .smooth_edges = true}),
            "on 4 edges are smooth: coverage and depth of 4 samples a pixel");
  EXPECT_EQ(told("samples", kPicture), "off 1 edges are not smoothed");
  EXPECT_EQ(told("samples", kBuffer), "off 1 the picture shows a buffer instead");
}

TEST(picture_modes, tell_each_texture_filter_in_other_words) {
  std::set<std::string> words;
  for (const FilterKind kind : {FilterKind::file, FilterKind::nearest, FilterKind::bilinear, FilterKind::trilinear,
                                FilterKind::anisotropic, FilterKind::rip_map}) {
    const std::string messages = told("texture filter", kPicture, {}, {.kind = kind});
    EXPECT_EQ(messages.starts_with("off"), kind == FilterKind::file) << messages;
    words.insert(messages);
  }
  EXPECT_EQ(words.size(), 6u);
  EXPECT_EQ(told("texture filter", kPicture, {}, {.kind = FilterKind::anisotropic, .anisotropy = 8}),
            "on 8 mip levels in places along a footprint");
}

TEST(picture_modes, tell_how_normals_lie_between_vertices) {
  RenderOptions options;
  EXPECT_EQ(told("quaternion normals", kPicture, options), "off linear between vertices, then unit again");
  options.normals = NormalInterpolation::quaternion;
  EXPECT_EQ(told("quaternion normals", kPicture, options), "on unit between vertices without a square root");
}

TEST(picture_modes, tell_the_tone_curve_and_where_it_changes_nothing) {
  EXPECT_EQ(told("tone curve", kPicture, with(ToneCurve::neutral)),
            "on PBR Neutral: base colours stay, highlights are compressed");
  EXPECT_EQ(told("tone curve", kPicture, with(ToneCurve::aces)), "on ACES: highlights lose colour, as on film");
  EXPECT_EQ(told("tone curve", kPicture, with(ToneCurve::none)), "off light is clipped at 1");
  EXPECT_EQ(told("tone curve", kBuffer, with(ToneCurve::aces)), "off the picture shows a buffer instead");
  EXPECT_EQ(told("tone curve", kGooch, with(ToneCurve::aces)), "off Gooch's tones are colours of the display");
  EXPECT_EQ(told("tone curve", kGooch, with(ToneCurve::aces, Backdrop::sharp)),
            "on for the backdrop alone: Gooch's tones are colours of the display");
  for (const auto hide : {+[](RenderOptions& o) { o.transparent_background = true; },
                          +[](RenderOptions& o) { o.lighting.environment = nullptr; }}) {
    RenderOptions options = with(ToneCurve::aces, Backdrop::sharp);
    hide(options);
    EXPECT_EQ(told("tone curve", kGooch, options), "off Gooch's tones are colours of the display");
  }
}

TEST(picture_modes, tell_the_backdrop_and_why_there_is_none) {
  RenderOptions options = with(ToneCurve::neutral, Backdrop::blurred);
  EXPECT_EQ(told("backdrop", kPicture, options), "on the environment, out of focus");
  EXPECT_EQ(told("backdrop", kBuffer, options), "off the picture shows a buffer instead");
  options.backdrop = Backdrop::sharp;
  EXPECT_EQ(told("backdrop", kPicture, options), "on the environment");
  options.lighting.environment_intensity = 0.0f;
  EXPECT_EQ(told("backdrop", kPicture, options), "off there is no environment to show");
  options.transparent_background = true;
  EXPECT_EQ(told("backdrop", kPicture, options), "off the background is transparent");
  EXPECT_EQ(told("backdrop", kPicture, with(ToneCurve::none)), "off a plain colour is asked for");
}

}  // namespace
}  // namespace sinew::viewer
