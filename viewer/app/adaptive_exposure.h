// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>

#include "runtime/model/scene.h"
#include "viewer/app/headless.h"
#include "viewer/app/options.h"

namespace sinew::viewer {

/// Exposure follows the picture by itself if light would clip more than this share of the model.
inline constexpr double kMostClipped = 0.2;

/// True if the light of this scene may be too bright for exposure 0: it has lamps, glowing materials, a panorama or
/// stronger environment light. False if the user chose the exposure, or if the picture shows no exposed light.
bool may_clip(const Options& options, const Scene& scene) noexcept;

/// Options of a small picture that shows the model alone, for clipped_share().
/// in   automatic  true = exposure follows the picture
Options probe_options(Options options, bool automatic);

/// Share of the opaque pixels in which a channel is at its end. A picture without opaque pixels has none.
double clipped_share(const Picture& picture) noexcept;

/// The sentence that tells the user why exposure follows the picture.
/// in   given, automatic  clipped shares of the model with exposure 0, and with automatic exposure
/// out  empty = exposure 0 stays: little is clipped, or automatic exposure clips nearly as much
std::string why_exposure_follows(double given, double automatic);

}  // namespace sinew::viewer
