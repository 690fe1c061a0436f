// SPDX-License-Identifier: MIT
#include "viewer/passes/picture_modes.h"

namespace sinew::viewer {
namespace {

constexpr std::string_view kBuffer = "the picture shows a buffer instead";

PictureMode samples(const FrameNeeds& needs) {
  const bool sampled = FrameGraph(needs).sampled;
  if (sampled) return {"samples", true, "edges are smooth: coverage and depth of 4 samples a pixel", 4};
  return {"samples", false, needs.smooth_edges ? kBuffer : "edges are not smoothed", 1};
}

PictureMode texture_filter(const TextureFilter& filter) {
  const auto by = [](std::string_view reason, std::uint64_t count = 0) {
    return PictureMode{"texture filter", true, reason, count};
  };
  switch (filter.kind) {
    case FilterKind::file: break;
    case FilterKind::nearest: return by("one texel of the full image");
    case FilterKind::bilinear: return by("four texels of the full image");
    case FilterKind::trilinear: return by("four texels in each of two mip levels");
    case FilterKind::anisotropic: return by("mip levels in places along a footprint", filter.anisotropy);
    case FilterKind::rip_map: return by("one level for the width of a footprint and one for its height");
  }
  return {"texture filter", false, "as the samplers of the file say"};
}

PictureMode normals(NormalInterpolation normals) {
  const bool quaternions = normals == NormalInterpolation::quaternion;
  return {"quaternion normals", quaternions,
          quaternions ? "unit between vertices without a square root" : "linear between vertices, then unit again"};
}

/// True if the environment is visible behind the scene.
bool environment_behind(const RenderOptions& options) {
  return options.backdrop != Backdrop::plain && options.lighting.ambient() && !options.transparent_background;
}

std::string_view why_tone_curve(const FrameNeeds& needs, const RenderOptions& options) {
  if (needs.show != Show::color) return kBuffer;
  if (options.lighting.tone_curve == ToneCurve::none) return "light is clipped at 1";
  if (needs.gooch)
    return environment_behind(options) ? "for the backdrop alone: Gooch's tones are colours of the display"
                                       : "Gooch's tones are colours of the display";
  return options.lighting.tone_curve == ToneCurve::aces ? "ACES: highlights lose colour, as on film"
                                                        : "PBR Neutral: base colours stay, highlights are compressed";
}

PictureMode tone_curve(const FrameNeeds& needs, const RenderOptions& options) {
  const bool runs = needs.show == Show::color && options.lighting.tone_curve != ToneCurve::none &&
                    (!needs.gooch || environment_behind(options));
  return {"tone curve", runs, why_tone_curve(needs, options)};
}

PictureMode backdrop(const FrameNeeds& needs, const RenderOptions& options) {
  const auto off = [](std::string_view reason) { return PictureMode{"backdrop", false, reason}; };
  if (needs.show != Show::color) return off(kBuffer);
  if (options.transparent_background) return off("the background is transparent");
  if (options.backdrop == Backdrop::plain) return off("a plain colour is asked for");
  if (!options.lighting.ambient()) return off("there is no environment to show");
  return {"backdrop", true, options.backdrop == Backdrop::sharp ? "the environment" : "the environment, out of focus"};
}

}  // namespace

std::array<PictureMode, kModeCount> describe_modes(const FrameNeeds& needs, const RenderOptions& options,
                                                   const TextureFilter& filter) {
  return {samples(needs), texture_filter(filter), normals(options.normals), tone_curve(needs, options),
          backdrop(needs, options)};
}

}  // namespace sinew::viewer
