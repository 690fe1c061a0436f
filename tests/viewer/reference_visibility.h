// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "tests/reference/ssao.h"
#include "tests/viewer/float_picture.h"
#include "viewer/passes/occlusion_shape.h"
#include "viewer/passes/render_options.h"
#include "viewer/passes/view.h"

namespace sinew::viewer {

/// Ambient visibility and bent normals of every pixel by the reference, with the viewer's sample offsets and noise.
reference::PixelVisibility reference_visibility(const reference::DepthAndNormals& image, const RenderOptions& options,
                                                const OcclusionShape& shape = {});

/// The floor of box_and_sphere_on_floor() with what stands on it, and nothing beyond.
inline View view_of_floor() { return look_at({2.5, 2.2, 4.0}, {0.0, 0.4, 0.0}, 0.8, 0.05); }

struct VisibilityDifference {
  double mean = 0.0, worst = 0.0;
  double darkest = 1.0;  ///< darkest expected value: without dark pixels, agreement proves nothing
  int far = 0;           ///< pixels that differ by more than 0.03
};
VisibilityDifference difference_of_visibility(const FloatPicture& picture, const std::vector<double>& expected);

}  // namespace sinew::viewer
