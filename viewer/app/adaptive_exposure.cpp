// SPDX-License-Identifier: MIT
#include "viewer/app/adaptive_exposure.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "viewer/light/rooms.h"

namespace sinew::viewer {
namespace {

constexpr std::uint32_t kProbeHeight = 180;
constexpr std::uint8_t kChannelEnd = 254;
constexpr double kUsefulGain = 0.5;  // automatic exposure must halve the clipped share

bool glows(const Material& material) noexcept { return material.emissive_strength > 1.0f; }

}  // namespace

bool may_clip(const Options& options, const Scene& scene) noexcept {
  if (options.exposure_is_given || options.show != Show::color || options.shading == Shading::gooch) return false;
  const bool panorama =
      !room_named(options.environment) && options.environment != "plain" && options.environment != "none";
  return panorama || options.environment_intensity > 1.0f || !scene.lights.empty() ||
         std::any_of(scene.materials.begin(), scene.materials.end(), glows);
}

Options probe_options(Options options, bool automatic) {
  const double aspect = static_cast<double>(options.width) / options.height;
  options.height = std::min(options.height, kProbeHeight);
  options.width = static_cast<std::uint32_t>(std::max(1.0, std::round(aspect * options.height)));
  options.transparent = true;
  options.ground = GroundLook::none;
  options.smooth_edges = false;
  options.skeleton = options.plan = false;
  options.auto_exposure = automatic;
  return options;
}

double clipped_share(const Picture& picture) noexcept {
  std::size_t model = 0, clipped = 0;
  for (std::size_t i = 0; i + 3 < picture.rgba.size(); i += 4) {
    const std::uint8_t* pixel = &picture.rgba[i];
    if (pixel[3] != 255) continue;
    ++model;
    clipped += std::max({pixel[0], pixel[1], pixel[2]}) >= kChannelEnd;
  }
  return model == 0 ? 0.0 : static_cast<double>(clipped) / static_cast<double>(model);
}

std::string why_exposure_follows(double given, double automatic) {
  if (given <= kMostClipped || automatic > kUsefulGain * given) return {};
  return "light would clip " + std::to_string(std::lround(100.0 * given)) +
         " % of the model: exposure follows the picture (--exposure 0 keeps it fixed)";
}

}  // namespace sinew::viewer
