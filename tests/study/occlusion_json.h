// SPDX-License-Identifier: MIT
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "tests/study/occlusion_study.h"

namespace sinew::viewer {

/// The study in the format that `sinew cost` reads: unrounded numbers, rows in the order of the study.
nlohmann::ordered_json json_of(const OcclusionStudy& study);

}  // namespace sinew::viewer
