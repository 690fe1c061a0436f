// SPDX-License-Identifier: MIT
#include "tests/viewer/reference_visibility.h"

#include <algorithm>
#include <cmath>

#include "tests/reference/gtao.h"
#include "viewer/passes/ssao_kernel.h"

namespace sinew::viewer {
namespace {

reference::SsaoSettings settings_of(const RenderOptions& options, const SsaoKernel& kernel,
                                    const OcclusionShape& shape) {
  const AmbientOcclusion& ao = options.ao;
  return {static_cast<double>(ao.radius_m),
          static_cast<double>(ao.surface_epsilon_m),
          static_cast<double>(ao.fade_start_m),
          static_cast<double>(ao.fade_end_m),
          2.0 * static_cast<double>(ao.power),
          kernel.offsets,
          kernel.noise,
          static_cast<int>(shape.step),
          static_cast<int>(shape.blur_reach),
          shape.keep_edges};
}

}  // namespace

reference::PixelVisibility reference_visibility(const reference::DepthAndNormals& image, const RenderOptions& options,
                                                const OcclusionShape& shape) {
  const SsaoKernel kernel = make_ssao_kernel(shape.samples);
  const reference::SsaoSettings settings = settings_of(options, kernel, shape);
  reference::HalfVisibility half =
      options.ao.method == OcclusionMethod::ssao
          ? reference::ssao(image, settings)
          : reference::horizon_visibility(
                image, {settings.radius, static_cast<int>(shape.slices), static_cast<int>(shape.steps), settings.step,
                        static_cast<double>(options.ao.power)});
  if (options.ao.blur) {
    half = reference::blurred(image, settings, half, false);
    half = reference::blurred(image, settings, half, true);
  }
  return reference::full_size(image, settings, half);
}

VisibilityDifference difference_of_visibility(const FloatPicture& picture, const std::vector<double>& expected) {
  VisibilityDifference d;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const double error = std::abs(static_cast<double>(picture.pixels[i].r) - expected[i]);
    d.mean += error / static_cast<double>(expected.size());
    d.worst = std::max(d.worst, error);
    d.far += error > 0.03;
    d.darkest = std::min(d.darkest, expected[i]);
  }
  return d;
}

}  // namespace sinew::viewer
