// SPDX-License-Identifier: MIT
#pragma once
#include <nlohmann/json.hpp>

#include "importer/tool/cost/report.h"

namespace sinew::cost {

/// Reads the name and the time of a trial from the output of a measuring program (tests/study).
/// in   key     member of `trial` with its milliseconds, one number per repetition;   pixels  drawn in each repetition
Point timed_point(const nlohmann::json& trial, const char* key, double pixels);

}  // namespace sinew::cost
