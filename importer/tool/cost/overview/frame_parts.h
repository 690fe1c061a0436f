// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string_view>
#include <vector>

#include "importer/tool/cost/overview/overview.h"
#include "importer/tool/cost/study.h"
#include "runtime/model/scene.h"

namespace sinew::cost {

// Names of parts that choices refer to.
inline constexpr const char *kSamplePart = "sample the clip", *kSkinPart = "skin vertices",
                            *kMorphPart = "morph vertices";

/// Measures the evaluation of one character on this thread: median times of the stages, which are joined to parts that
/// a reader knows. Stages that do not run have no part.
/// in   clip  kNone = nothing moves, so there are no parts
/// cost some hundred frames
std::vector<FramePart> evaluation_parts(const Scene& scene, std::uint32_t clip, const Effort& effort);

/// Reads the times of upload and passes in what `sinew-viewer --plan` prints. Unknown passes keep their names.
std::vector<FramePart> drawing_parts(std::string_view plan);

}  // namespace sinew::cost
