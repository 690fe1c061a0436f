// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "tests/reference/ssao.h"
#include "viewer/passes/occlusion_shape.h"
#include "viewer/passes/render_options.h"

namespace sinew::viewer {

/// Ambient access and bend of every pixel by the plain reference, with the offsets and the noise of the viewer.
reference::PixelAccess reference_access(const reference::DepthAndNormals& image, const RenderOptions& options,
                                        const OcclusionShape& shape = {});

}  // namespace sinew::viewer
