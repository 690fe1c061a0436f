// SPDX-License-Identifier: MIT
#pragma once
#include <nlohmann/json.hpp>

#include "importer/tool/cost/report.h"

namespace sinew::cost {

/// The name and the time of a trial that a measuring program (tests/study) answers.
/// in   key     of its list of milliseconds, one a repetition;   pixels  that each took
Point timed_point(const nlohmann::json& trial, const char* key, double pixels);

}  // namespace sinew::cost
