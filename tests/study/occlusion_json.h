// SPDX-License-Identifier: MIT
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "tests/study/occlusion_study.h"

namespace sinew::viewer {

/// The study as `sinew cost` reads it: each number as it was measured, rows in the order of the study.
nlohmann::ordered_json json_of(const OcclusionStudy& study);

}  // namespace sinew::viewer
